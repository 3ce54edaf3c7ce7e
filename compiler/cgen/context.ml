open Basis
module M = Step.Ir
module V = Vocabulary

type t = {
  v : V.t;
  names : Expression.names;
  index : int;
  node : M.node;
  write : int -> Ir.expr -> Ir.statement;  (** an output *)
  read : unit Basis.Int_table.t;  (** variables that anything reads *)
  mutable place : string;  (** the source line last mentioned *)
}

let plain desc : Ir.statement = { desc; comment = "" }

(* Mentions the source line of a statement unless the one before did. *)
let comment c (span : Span.t) =
  let line = Span.line span.start in
  let place =
    if String.equal span.file c.node.file then "line " ^ string_of_int line
    else Printf.sprintf "%s:%d" (Printable.name (Filename.basename span.file)) line
  in
  if String.equal place c.place then ""
  else (
    c.place <- place;
    place)

let expression c = Expression.of_step c.names

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
  let own = List.filter (fun v -> not (Expression.is_elsewhere c.names v)) variables in
  List.rev (declared c (List.map (fun v -> (v, Expression.variable c.names v)) own))

let in_seconds c ns = Ir.Binary (Over, Cast (V.real c.v, ns), V.float c.v 1e9)

type time =
  | Passed
  | None_passed  (** the callee's first instant *)

(* [own]: the address of the state, if there is one. *)
let step_call ?(time = Passed) c ~node ~own arguments results =
  let callee = c.v.program.nodes.(node) in
  let given is_read name zero =
    if not is_read then []
    else match time with Passed -> [ Ir.Name name ] | None_passed -> [ zero ]
  in
  let dt = given callee.seconds "dt" (V.float c.v 0.) in
  let dt_ns = given callee.nanoseconds "dt_ns" (Ir.Integer 0l) in
  Ir.Call (c.v.nodes.(node).step, List.concat [ own; dt; dt_ns; arguments; results ])

let is_given c node = Program_input.is_given c.v.by_pointer node

(* For the parameters of a node's code that it does not read by the pointer to the input. *)
let for_code c node given (code : M.code) arguments =
  let is_read_there v = Option.is_some (Program_input.member c.v.by_pointer node v) in
  let parameters, arguments =
    List.split
      (List.filter (fun (v, _) -> not (is_read_there v)) (List.combine code.parameters arguments))
  in
  (if given then [ Ir.Name "in" ] else []) @ Expression.arguments c.names parameters arguments

(* A node's start, which knows that no time has passed. *)
let start_call c ~node ~own arguments results =
  match (c.v.program.nodes.(node).start, c.v.nodes.(node).start) with
  | Some start, Some name ->
      let given = Program_input.is_start_given c.v.by_pointer node in
      Ir.Call (name, List.concat [ own; for_code c node given start arguments; results ])
  | _, _ -> Diagnostic.bug ~stage:"Cgen.Context" "a start that is not there"

(* Of functions with several outputs the caller passes addresses for them. *)
let returns_result (node : M.node) = match node.outputs with [ _ ] -> true | _ -> false

let own_state c state =
  let address field = Ir.Unary (Address, Expression.field c.names field) in
  Option.to_list (Option.map address state)

(* Arguments of a node's functions. *)
let for_step c node = for_code c node (is_given c node) c.v.program.nodes.(node).step

let for_reset c node = Expression.arguments c.names c.v.program.nodes.(node).reset.parameters
