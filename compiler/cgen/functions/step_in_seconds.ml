module V = Vocabulary
open Context

let dt = Ir.Name "dt"
let set_dt value = plain (Ir.Assign (dt, value))

let at_first (v : Program_names.t) ~root zero value =
  match v.program.started with
  | None -> value
  | Some { field; own = _ } ->
      Ir.Conditional (Expression.field (Expression.names v ~node:root) field, value, zero)

let mark (v : Program_names.t) ~root =
  match v.program.started with
  | None | Some { own = false; _ } -> []
  | Some { field; own = true } ->
      [ plain (Ir.Assign (Expression.field (Expression.names v ~node:root) field, Boolean true)) ]

(* The statements that convert dt, and the arguments for the step's parameters dt_ns and dt. A time
   that the step does not read is 0. *)
let times (v : Program_names.t) ~root =
  let node = v.program.nodes.(root) in
  let none = V.float v 0. in
  if node.nanoseconds || (node.seconds && v.program.real = Single) then
    let rounded = at_first v ~root (Ir.Integer 0l) (V.call v "frob_whole_ns" [ dt ]) in
    let dt_ns = Ir.Name "dt_ns" in
    ( [ plain (Ir.Variable { ty = Int64; name = "dt_ns"; value = rounded }) ],
      (dt_ns, if node.seconds then in_seconds v dt_ns else none) )
  else if node.seconds then
    (* Replace dt with 0 first: if this came last, C compilers would duplicate the step. *)
    let whole = Ir.Call ("frob_whole_dt", [ dt ]) in
    match at_first v ~root none dt with
    | Name _ -> ([], (Ir.Integer 0l, whole))
    | first -> ([ set_dt first ], (Ir.Integer 0l, whole))
  else ([ plain (Ir.Do (Cast (Void, dt))) ], (Ir.Integer 0l, none))

let of_step (v : Program_names.t) ~root (step : Ir.function_) : Ir.function_ =
  let conversions, (dt_ns, dt) = times v ~root in
  let argument (_, name) = match name with "dt_ns" -> dt_ns | "dt" -> dt | name -> Ir.Name name in
  let call = plain (Ir.Do (Call (step.name, List.map argument step.parameters))) in
  {
    step with
    name = v.in_seconds;
    parameters = List.filter (fun (_, name) -> name <> "dt_ns") step.parameters;
    body = conversions @ mark v ~root @ [ call ];
  }
