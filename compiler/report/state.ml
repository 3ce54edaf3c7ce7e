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

(* First the struct of each node, then those of small fields. *)
type t = { definitions : definition array; nodes : int }

let root t = t.nodes - 1
let definition t k = t.definitions.(k)

let bytes_of_node t k = Amount.add t.definitions.(k).bytes t.definitions.(t.nodes + k).bytes

(* The number of a mode is a byte while that is enough. *)
let running_mode (node : M.node) : Block.t =
  if List.compare_length_with node.modes 256 <= 0 then { bytes = 1; alignment = 1 }
  else { bytes = 4; alignment = 4 }

type context = {
  program : M.program;
  apart : Machine.Apart.t;
  blocks : Block.t array;  (** of the nodes before *)
  small : Block.t array;  (** likewise, of their structs of small fields *)
}

(* The members of a struct with these fields, and its room. *)
let rec members c k fields =
  let contents = List.rev_map (content c k) fields in
  let contents = List.rev contents in
  let offsets, block = Block.of_members (Long_list.map fst contents) in
  let member (placed, fields, offsets) (room, holds) =
    match (fields, offsets) with
    | ((field : M.field), _) :: fields, offset :: offsets ->
        let bytes = room.Block.bytes in
        ({ name = field.name; offset; bytes; holds; span = field.span } :: placed, fields, offsets)
    | _, _ -> (placed, fields, offsets)
  in
  let placed, _, _ = List.fold_left member ([], fields, offsets) contents in
  (List.rev placed, block)

and content c k ((field : M.field), (part : Machine.Apart.part)) =
  (* What has one struct has that one, be it of small fields only. *)
  let struct_of node =
    if part = Small && Machine.Apart.is_split c.apart node then
      (c.small.(node), Array.length c.blocks + node)
    else (c.blocks.(node), node)
  in
  match field.content with
  | Value ty -> (Block.of_value c.program.real c.program.sums ty, Value field.purpose)
  | State_of node ->
      let block, index = struct_of node in
      (block, Struct index)
  | States_of { node; count } ->
      let block, index = struct_of node in
      (Block.run count block, Structs { node = index; count })
  | Running_mode -> (running_mode c.program.nodes.(k), Running_mode)
  | Component symbol -> (Block.foreign, Value (Printf.sprintf "`struct %s_state`" symbol))
  | Modes modes ->
      let alternatives = List.map (alternative c k part) modes in
      (Block.of_alternatives (List.map snd alternatives), Largest (List.map fst alternatives))

and alternative c k part (mode : M.mode) =
  let fields = Machine.Apart.in_order c.apart k (Machine.State.fields_of_mode mode) in
  let members, block = members c k (List.filter (fun (_, p) -> p = part) fields) in
  ({ mode = c.program.nodes.(mode.node).origin; node = mode.node; bytes = block.bytes; members }, block)

let of_program (program : M.program) =
  let count = Array.length program.nodes in
  let none = { Block.bytes = 0; alignment = 1 } in
  let c =
    {
      program;
      apart = Machine.Apart.of_program program;
      blocks = Array.make count none;
      small = Array.make count none;
    }
  in
  let definition (node : M.node) name bytes members =
    { name; file = node.file; span = node.span; bytes; members }
  in
  let of_node k (node : M.node) =
    let fields = Machine.Apart.in_order c.apart k node.state in
    let large, small =
      if Machine.Apart.is_split c.apart k then
        List.partition (fun (_, part) -> part = Machine.Apart.Large) fields
      else (fields, [])
    in
    let members, block = members c k large and small_members, small = members c k small in
    (* C has no struct without members. *)
    let block = if k = count - 1 then { block with bytes = max 1 block.bytes } else block in
    c.blocks.(k) <- block;
    c.small.(k) <- small;
    ( definition node node.origin block.bytes members,
      definition node (node.origin ^ ", small fields") small.bytes small_members )
  in
  let both = Array.mapi of_node program.nodes in
  { definitions = Array.append (Array.map fst both) (Array.map snd both); nodes = count }

let in_use t =
  let seen = Array.make (Array.length t.definitions) false in
  let rec visit found k =
    if seen.(k) then found
    else begin
      seen.(k) <- true;
      List.fold_left inside (k :: found) t.definitions.(k).members
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
