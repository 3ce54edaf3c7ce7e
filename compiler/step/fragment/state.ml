open Basis
open Flow.Ir

type memory =
  | Delayed of Ir.field
  | Elapsed of { time : Ir.field; restart : atom }
  | Ticked of { time : Ir.field; period : atom }
  | Integrated of { value : Ir.field; input : Ir.expr }
  | Differentiated of { value : Ir.field; input : Ir.field }
  | Kept of Ir.field

type t = {
  memories : memory Int_table.t;
  instances : (string, Ir.field) Hashtbl.t;
  mutable fields : Ir.field list;  (** newest first *)
  mutable machine : machine option;
  mutable count : int;
}

and machine = { clock : Ir.clock option; modes : Ir.mode list }

let numbered ?origin t ~name content ~purpose span : Ir.field =
  let id = t.count in
  t.count <- t.count + 1;
  { id; name; content; bound = None; purpose; origin; span }

let new_field ?origin t ~name content ~purpose span =
  let field = numbered ?origin t ~name content ~purpose span in
  t.fields <- field :: t.fields;
  field

let machine t = t.machine
let modes t = match t.machine with None -> [] | Some machine -> machine.modes
let fields_of_mode (mode : Ir.mode) = List.map snd mode.parameters @ Option.to_list mode.state
let fields t = List.rev t.fields
let memory t (s : signal) = Int_table.find_opt t.memories s.id
let instance t (i : instance) = Hashtbl.find_opt t.instances i.name
let atom_name = function Signal s -> s.name | Bool _ | Int _ | Float _ -> ""

(* A name for the state of the operation that computes [s] from [atom]: the name of [s] or, if it
   has none, one derived from the name of [atom]. *)
let derived (s : signal) atom ~suffix ~otherwise =
  match (s.name, atom_name atom) with
  | "", "" -> otherwise
  | "", operand -> operand ^ "_" ^ suffix
  | name, _ -> name

let origin (s : signal) : Ir.origin = { signal = s.name; written = s.span; role = Its_value }

(* A delay stores the values of its operand, which may have a name even if the delay has none. *)
let origin_of_delay (s : signal) next =
  match next with Signal next when s.name = "" && next.name <> "" -> origin next | _ -> origin s

let remember t (s : signal) memory = Int_table.replace t.memories s.id memory
let value (ty : ty) : Ir.content = Value (Layout.ty ty)
let past_first = "true after the first instant"

let equation t { defines = s; rhs; span } =
  let field ~origin ~name purpose = new_field ~origin t ~name (Value Float) ~purpose span in
  match rhs with
  | Delay { init = Bool false; next = Bool true } ->
      let name = if String.equal s.name "" then "started" else s.name in
      remember t s (Delayed (new_field t ~name (Value Bool) ~purpose:past_first span))
  | Delay { next; _ } ->
      let name = derived s next ~suffix:"prev" ~otherwise:"delay" in
      let origin = origin_of_delay s next in
      remember t s (Delayed (new_field ~origin t ~name (value s.ty) ~purpose:"delay" span))
  | Time { restart } ->
      let name = if String.equal s.name "" then "time" else s.name in
      let time = new_field t ~name (Value Nanoseconds) ~purpose:"time in ns" span in
      remember t s (Elapsed { time; restart })
  | Ticks period ->
      let name = derived s period ~suffix:"ticks" ~otherwise:"ticks" in
      let time = new_field t ~name (Value Nanoseconds) ~purpose:"ns since the last tick" span in
      remember t s (Ticked { time; period })
  | Integral input ->
      let name = derived s input ~suffix:"integral" ~otherwise:"integral" in
      let value = field ~origin:(origin s) ~name "integral" in
      let input : Ir.expr =
        match input with
        | Float x when Float.is_finite x -> Float x
        | Signal _ | Bool _ | Int _ | Float _ ->
            let origin = { (origin s) with role = Its_integrand } in
            Field (field ~origin ~name:(name ^ "_input") "previous input")
      in
      remember t s (Integrated { value; input })
  | Derivative input ->
      let name = derived s input ~suffix:"derivative" ~otherwise:"derivative" in
      let value = field ~origin:(origin s) ~name "derivative" in
      let origin = { (origin s) with role = Its_integral } in
      let input = field ~origin ~name:(name ^ "_input") "previous input" in
      remember t s (Differentiated { value; input })
  | Copy _ | Op _ | If _ | Construct _ | Is_constructor _ | Payload _ | Elements _ | Param _
  | Absent | Fill _ | Index _ | At _ | Replace _ | Step_time ->
      ()

let kept_name rhs =
  let after operator operand =
    operator ^ "_" ^ match atom_name operand with "" -> "value" | name -> name
  in
  match rhs with
  | Op (Elementary e, operand :: _) -> after (Core.Primitive_table.name (Elementary e)) operand
  | Op (Pow, operand :: _) -> after "pow" operand
  | _ -> "start_value"

(* A mode stores only the parameters that its step reads. *)
let mode t ~callee ~statics index : Ir.mode =
  let node : Ir.node = callee index in
  let is_read (v : Ir.variable) =
    List.exists (fun (read : Ir.variable) -> read.id = v.id) node.step.parameters
  in
  let parameter ((v : Ir.variable), origin) =
    let name = if String.equal v.name "" then "parameter" else v.name in
    (v, numbered ~origin t ~name (Value v.ty) ~purpose:"parameter" node.span)
  in
  let state =
    match node.state with
    | [] -> None
    | _ :: _ -> Some (numbered t ~name:"state" (State_of index) ~purpose:"" node.span)
  in
  {
    node = index;
    name = node.name;
    parameters = List.map parameter (List.filter (fun (v, _) -> is_read v) (statics index));
    state;
  }

let machine_of t ~callee ~statics (m : Flow.Ir.machine) =
  let modes = List.map (mode t ~callee ~statics) m.modes in
  let keeps (mode : Ir.mode) = mode.parameters <> [] || Option.is_some mode.state in
  let field name content purpose = new_field t ~name content ~purpose m.span in
  (* A single mode needs no number. *)
  if List.compare_length_with modes 1 > 0 then
    ignore (field "mode" Ir.Running_mode "active mode" : Ir.field);
  if List.exists keeps modes then
    ignore (field "modes" (Ir.Modes modes) "state of the modes" : Ir.field);
  let looks_at_time mode =
    let node : Ir.node = callee mode in
    node.seconds || node.nanoseconds
  in
  let clock =
    match m.active with
    | Some _ when List.exists looks_at_time m.modes ->
        let since = field "since" (Ir.Value Nanoseconds) "ns since the modes last ran" in
        let running = field "running" (Ir.Value Bool) "true after the modes' first instant" in
        Some { Ir.since; running; elapsed = Later (Field since, Dt_nanoseconds) }
    | Some _ | None -> None
  in
  t.machine <- Some { clock; modes }

let of_node ~callee ~statics:(statics_of : int -> (Ir.variable * Ir.origin) list)
    (statics : Statics.t) =
  let t =
    {
      memories = Int_table.create 16;
      instances = Hashtbl.create 16;
      fields = [];
      machine = None;
      count = 0;
    }
  in
  let stateful index = match (callee index : Ir.node).state with [] -> false | _ :: _ -> true in
  List.iter
    (fun (item : Flow.Schedule.item) ->
      match item with
      | Equation eq -> equation t eq
      | Instance i ->
          if stateful i.node then
            Hashtbl.replace t.instances i.name
              (new_field t ~name:i.name
                 (match i.loop with
                 | None -> State_of i.node
                 | Some { count; _ } -> States_of { node = i.node; count })
                 ~purpose:"" i.span)
      | Trial _ -> ()
      | Machine m -> machine_of t ~callee ~statics:statics_of m)
    statics.in_step;
  let is_kept = Int_table.create 16 in
  List.iter (fun (s : signal) -> Int_table.replace is_kept s.id ()) statics.kept;
  let keep ~name span (s : signal) =
    if Int_table.mem is_kept s.id then
      (* An unnamed signal may be an intermediate result, whose span is the span of the
         operation. *)
      let origin = if String.equal s.name "" then None else Some (origin s) in
      let name = if String.equal s.name "" then name else s.name in
      let purpose = "computed by reset" in
      remember t s (Kept (new_field ?origin t ~name (value s.ty) ~purpose span))
  in
  List.iter
    (fun (item : Flow.Schedule.item) ->
      match item with
      | Equation eq -> keep ~name:(kept_name eq.rhs) eq.span eq.defines
      | Instance i -> List.iter (keep ~name:i.name i.span) i.outputs
      | Trial _ | Machine _ -> ())
    statics.at_reset;
  t
