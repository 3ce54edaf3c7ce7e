open Basis
module M = Step.Ir
module V = Vocabulary

type t = {
  v : Program_names.t;
  names : Expression.names;
  index : int;
  node : M.node;
  write : int -> Ir.expr -> Ir.statement;  (** assigns a value to an output *)
  read : unit Basis.Int_table.t;  (** variables that are read *)
  mutable place : string;  (** the source line in the last comment *)
}

let plain desc : Ir.statement = { desc; comment = "" }

(* A comment with the source line of a statement, unless the previous comment has the same line. *)
let comment c (span : Span.t) =
  let line = Span.line span.start in
  let place =
    if String.equal span.file c.node.file then "line " ^ string_of_int line
    else Printf.sprintf "%s:%d" (C_string.comment (Filename.basename span.file)) line
  in
  if String.equal place c.place then ""
  else (
    c.place <- place;
    place)

let expression c = Expression.of_step c.names
let value c ~at = Expression.operand c.names ~at

let declared c variables =
  let declare groups ((variable : M.variable), name) =
    let ty = V.ty c.v variable.ty in
    match groups with
    | (last, names) :: groups when last = ty -> (last, name :: names) :: groups
    | groups -> (ty, [ name ]) :: groups
  in
  List.rev_map
    (fun (ty, names) -> plain (Ir.Variables { ty; names = List.rev names }))
    (List.fold_left declare [] variables)

let uninitialized c variables =
  List.rev (declared c (List.map (fun v -> (v, Expression.variable c.names v)) variables))

let in_seconds v ns = Ir.Binary (Over, Cast (V.real v, ns), V.float v 1e9)

(* [own]: the address of the state, if there is one. *)
let step_call ?(entered = false) c ~node ~own arguments results =
  let callee = c.v.program.nodes.(node) in
  let given is_read name = if is_read then [ Ir.Name name ] else [] in
  let params = given (Step.Param_use.in_step c.v.param_use node) "params" in
  let time is_read name zero = if entered && is_read then [ zero ] else given is_read name in
  let dt = time callee.seconds "dt" (V.float c.v 0.) in
  let dt_ns = time callee.nanoseconds "dt_ns" (Ir.Integer 0l) in
  Ir.Call (c.v.nodes.(node).step, List.concat [ own; params; dt; dt_ns; arguments; results ])

(* Omits the parameters that the callee reads through the pointer to the input. *)
let for_step c node arguments =
  let is_read_there v = Option.is_some (Program_input.member c.v.by_pointer node v) in
  let parameters, arguments =
    List.combine c.v.program.nodes.(node).step.parameters arguments
    |> List.filter (fun (v, _) -> not (is_read_there v))
    |> List.split
  in
  (if Program_input.is_given c.v.by_pointer node then [ Ir.Name "in" ] else [])
  @ Expression.arguments c.names parameters arguments

let own_state c state = Option.to_list (Option.map (Expression.state c.names) state)

let for_reset c node given =
  let params = if Step.Param_use.in_reset c.v.param_use node then [ Ir.Name "params" ] else [] in
  params @ Expression.arguments c.names c.v.program.nodes.(node).reset.parameters given
