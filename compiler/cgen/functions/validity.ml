module V = Vocabulary
open Context

let is_machine (node : M.node) = match node.modes with [] | [ _ ] -> false | _ :: _ :: _ -> true

(* For each node, whether its state contains the number of a running mode. One pass is enough,
   because a node contains only nodes with smaller indices. *)
let nodes_with_machines (program : M.program) =
  let has = Array.make (Array.length program.nodes) false in
  let rec contains (field : M.field) =
    match field.content with
    | Value _ | Running_mode | Component _ -> false
    | State_of k | States_of { node = k; _ } -> has.(k)
    | Modes modes ->
        List.exists (fun mode -> List.exists contains (Step.State.fields_of_mode mode)) modes
  in
  let note k (node : M.node) =
    has.(k) <- Option.is_none node.foreign && (is_machine node || List.exists contains node.state)
  in
  Array.iteri note program.nodes;
  has

let valid = Ir.Name "valid"

(* [valid] stays true only if this condition also holds. *)
let require condition = plain (Ir.Assign (valid, Binary (And, valid, condition)))

type t = {
  v : Program_names.t;
  has : bool array;
  names : string array;  (** name of the checking function of each node; [""] if it has none *)
}

(* Checks that the number of the running mode is one of the modes' constants. *)
let in_range (v : Program_names.t) k running =
  let modes = v.nodes.(k).modes in
  let count = Array.length modes in
  let last = Ir.Name modes.(count - 1).constant in
  let at_most = Ir.Binary (Less_equal, running, last) in
  if count = 256 then []
  else if count > 256 then
    [ require (Binary (And, Binary (Less_equal, Name modes.(0).constant, running), at_most)) ]
  else [ require at_most ]

(* The checks of the state of node [k], which is part of the struct that [self] points to. *)
let rec checks t k =
  let node = t.v.program.nodes.(k) in
  let names = Expression.names t.v ~node:k in
  let rec field (f : M.field) =
    match f.content with
    | Value _ | Running_mode | Component _ -> []
    | State_of inner when not t.has.(inner) -> []
    | State_of inner when V.home t.v inner = V.home t.v k -> checks t inner
    | State_of inner -> [ require (Call (t.names.(inner), [ Expression.state names f ])) ]
    | States_of { node = inner; _ } when not t.has.(inner) -> []
    | States_of { node = inner; count } ->
        let index = Expression.index names 0 in
        let element = Ir.Subscript (Expression.field names f, Name index) in
        let body = [ require (Call (t.names.(inner), [ Unary (Address, element) ])) ] in
        [ plain (Ir.For { index; count; body }) ]
    | Modes modes -> List.concat (List.mapi mode modes)
  and mode number (mode : M.mode) =
    match (List.concat_map field (Step.State.fields_of_mode mode), running) with
    | [], _ -> []
    | checks, None -> checks
    | checks, Some running ->
        let runs = Ir.Binary (Equal, running, Name t.v.nodes.(k).modes.(number).constant) in
        [ plain (Ir.If { condition = Binary (And, valid, runs); then_ = checks; else_ = [] }) ]
  and running =
    let is_running (f : M.field) = f.content = Running_mode in
    Option.map (Expression.field names) (List.find_opt is_running node.state)
  in
  let own = match running with Some running -> in_range t.v k running | None -> [] in
  own @ List.concat_map field node.state

(* The first check initializes [valid]. A single check is returned directly, without a variable. *)
let body checks =
  let start value = plain (Ir.Variable { ty = Bool; name = "valid"; value }) in
  let return value = [ plain (Ir.Return value) ] in
  match checks with
  | [ { Ir.desc = Assign (_, Binary (And, _, condition)); _ } ] -> return condition
  | { Ir.desc = Assign (_, Binary (And, _, condition)); _ } :: others ->
      (start condition :: others) @ return valid
  | checks -> (start (Boolean true) :: checks) @ return valid

let function_ t k : Ir.function_ =
  {
    linkage = (if V.is_root t.v k then External else Static);
    result = Bool;
    name = t.names.(k);
    parameters = [ (Pointer_to_const (Struct (V.state_struct t.v k)), "self") ];
    body = body (checks t k);
    comment = "";
  }

let functions (v : Program_names.t) =
  let has = nodes_with_machines v.program in
  let root = Array.length has - 1 in
  let is_home k = has.(k) && V.home v k = k in
  let name k =
    if k = root then v.is_valid
    else if is_home k then
      Name.fresh v.file_scope (String.concat "_" [ v.name; v.program.nodes.(k).name; "is_valid" ])
    else ""
  in
  let t = { v; has; names = Array.init (root + 1) name } in
  List.filter_map
    (fun k -> if is_home k then Some (function_ t k) else None)
    (List.init (root + 1) Fun.id)
