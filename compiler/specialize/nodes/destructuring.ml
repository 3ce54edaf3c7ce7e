module Ir = Core.Ir
module Parts = Map.Make (String)

(* The names of the parts, by path. The path of the parameter itself is [""]. *)
type t = { parameter : int; parts : string Parts.t }

let none = { parameter = min_int; parts = Parts.empty }

(* The path of the expression, if it is a part of the parameter. *)
let rec path types substitution (parameter : Ir.binder) (e : Ir.expr) =
  let below value part =
    let join path = Types.join path part in
    Option.map join (path types substitution parameter value)
  in
  match e.desc with
  | Local local -> if local.id = parameter.local.id then Some "" else None
  | Component (value, index) -> below value (string_of_int (index + 1))
  | Payload { value; field; constructor = _ } -> (
      match (Types.layout types (Types.close substitution value.ty)).kind with
      | Product parts -> below value (List.nth parts field).part
      | Scalar | Sum _ | Array _ | Opaque -> None)
  | Global _ | Primitive _ | Method _ | Number _ | Boolean _ | String _ | Lambda _ | Apply _ | Let _
  | Tuple _ | Array _ | Index _ | Construct _ | Is_constructor _ | If _ | Proc _ ->
      None

let note types substitution parameter parts (binder : Ir.binder) value =
  if String.equal binder.local.name "" then parts
  else
    match path types substitution parameter value with
    | Some path when not (Parts.mem path parts) -> Parts.add path binder.local.name parts
    | Some _ | None -> parts

let of_lambda types substitution (parameter : Ir.binder) body =
  let rec lets parts (e : Ir.expr) =
    match e.desc with
    | Let { binder; value; body } ->
        lets (note types substitution parameter parts binder value) body
    | _ -> parts
  in
  { parameter = parameter.local.id; parts = lets Parts.empty body }

let of_proc types substitution (proc : Ir.proc) =
  let equation parts (eq : Ir.equation) =
    match eq.rhs with
    | Pure value -> note types substitution proc.input parts eq.binder value
    | Run _ -> parts
  in
  { parameter = proc.input.local.id; parts = List.fold_left equation Parts.empty proc.equations }

(* The name of the nearest enclosing part that has a name, followed by the rest of the path. *)
let rec around parts prefix rest =
  match (Parts.find_opt prefix parts, String.rindex_opt prefix '.') with
  | Some name, _ -> Types.join name rest
  | None, Some dot ->
      let last = String.sub prefix (dot + 1) (String.length prefix - dot - 1) in
      around parts (String.sub prefix 0 dot) (Types.join last rest)
  | None, None -> (
      match Parts.find_opt "" parts with
      | Some name -> Types.join name (Types.join prefix rest)
      | None -> "")

let name t (local : Ir.Local.t) path =
  if not (String.equal local.name "") then Types.join local.name path
  else if local.id = t.parameter then around t.parts path ""
  else ""
