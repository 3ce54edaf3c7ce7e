open Basis
module M = Machine.Ir

type member = {
  name : string;
  offset : int;
  bytes : int;
  holds : holds;
  span : Span.t;
}

and holds =
  | Value of string
  | Struct of int
  | Structs of { node : int; count : int }
  | Running_mode
  | Largest of alternative list

and alternative = {
  mode : string;
  node : int;
  bytes : int;
  members : member list;
}

type definition = {
  name : string;
  file : string;
  span : Span.t;
  bytes : int;
  members : member list;
}

type t = definition array

let root t = Array.length t - 1
let definition t k = t.(k)

(* The number of a mode is a byte while that is enough. *)
let running_mode (node : M.node) : Block.t =
  if List.compare_length_with node.modes 256 <= 0 then { bytes = 1; alignment = 1 }
  else { bytes = 4; alignment = 4 }

type context = { program : M.program; blocks : Block.t array  (** of the nodes before *) }

(* The members of a struct with these fields, and its room. *)
let rec members c node fields =
  let contents = List.rev_map (content c node) fields in
  let contents = List.rev contents in
  let offsets, block = Block.of_members (Long_list.map fst contents) in
  let member (placed, fields, offsets) (room, holds) =
    match (fields, offsets) with
    | (field : M.field) :: fields, offset :: offsets ->
        let bytes = room.Block.bytes in
        ({ name = field.name; offset; bytes; holds; span = field.span } :: placed, fields, offsets)
    | _, _ -> (placed, fields, offsets)
  in
  let placed, _, _ = List.fold_left member ([], fields, offsets) contents in
  (List.rev placed, block)

and content c node (field : M.field) =
  match field.content with
  | Value ty -> (Block.of_value c.program.real c.program.sums ty, Value field.purpose)
  | State_of k -> (c.blocks.(k), Struct k)
  | States_of { node; count } -> (Block.run count c.blocks.(node), Structs { node; count })
  | Running_mode -> (running_mode node, Running_mode)
  | Component symbol -> (Block.foreign, Value (Printf.sprintf "`struct %s_state`" symbol))
  | Modes modes ->
      let alternatives = List.map (alternative c node) modes in
      (Block.of_alternatives (List.map snd alternatives), Largest (List.map fst alternatives))

and alternative c node (mode : M.mode) =
  let members, block = members c node (Machine.State.fields_of_mode mode) in
  ({ mode = c.program.nodes.(mode.node).origin; node = mode.node; bytes = block.bytes; members }, block)

let of_program (program : M.program) =
  let count = Array.length program.nodes in
  let c = { program; blocks = Array.make count { Block.bytes = 0; alignment = 1 } } in
  Array.mapi
    (fun k (node : M.node) ->
      let members, block = members c node node.state in
      (* C has no struct without members. *)
      let block = if k = count - 1 then { block with bytes = max 1 block.bytes } else block in
      c.blocks.(k) <- block;
      { name = node.origin; file = node.file; span = node.span; bytes = block.bytes; members })
    program.nodes

let in_use t =
  let seen = Array.make (Array.length t) false in
  let rec visit found k =
    if seen.(k) then found
    else begin
      seen.(k) <- true;
      List.fold_left inside (k :: found) t.(k).members
    end
  and inside found (member : member) =
    match member.holds with
    | Value _ | Running_mode -> found
    | Struct k | Structs { node = k; count = _ } -> visit found k
    | Largest alternatives ->
        List.fold_left
          (fun found (a : alternative) -> List.fold_left inside found a.members)
          found alternatives
  in
  List.rev (visit [] (root t))

let padding ~bytes members =
  bytes - List.fold_left (fun sum (member : member) -> Amount.add sum member.bytes) 0 members

let foreign (program : M.program) =
  let rec of_value found (ty : M.ty) =
    match ty with
    | Foreign { c_type; copyable = true; _ } -> c_type :: found
    | Foreign _ | Bool | Int | Float | Nanoseconds -> found
    | Array (_, element) -> of_value found element
    | Sum k ->
        List.fold_left
          (fun found (ty, _) -> of_value found (Machine.Layout.ty ty))
          found (Machine.Layout.sum program.sums k).arrays
  in
  let rec of_field found (f : M.field) =
    match f.content with
    | Value ty -> of_value found ty
    | Component symbol -> Printf.sprintf "struct %s_state" symbol :: found
    | Modes modes ->
        List.fold_left
          (fun found m -> List.fold_left of_field found (Machine.State.fields_of_mode m))
          found modes
    | State_of _ | States_of _ | Running_mode -> found
  in
  let of_node found (node : M.node) = List.fold_left of_field found node.state in
  List.sort_uniq String.compare (Array.fold_left of_node [] program.nodes)
