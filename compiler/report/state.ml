open Basis
module M = Step.Ir

type member = { name : string; offset : int; bytes : int; holds : holds; span : Span.t }

and holds =
  | Value of string
  | Struct of int
  | Structs of { node : int; count : int }
  | Running_mode
  | Largest of alternative list

and alternative = { mode : string; node : int; bytes : int; members : member list }

type definition = {
  name : string;
  file : string;
  span : Span.t;
  bytes : int;
  members : member list;
}

(* The state struct of each node. *)
type t = definition array

let root t = Array.length t - 1
let definition = Array.get

(* [structs]: size and alignment of the preceding nodes' structs. *)
type context = { program : M.program; structs : Step.Block.t array }

(* A running mode is stored in one byte if there are at most 256 modes. *)
let running_mode (node : M.node) : Step.Block.t =
  let bytes = if List.compare_length_with node.modes 256 <= 0 then 1 else 4 in
  { bytes; alignment = bytes }

let rec block c k (field : M.field) =
  match field.content with
  | Value ty -> Step.Block.of_value c.program.real c.program.sums ty
  | State_of node -> c.structs.(node)
  | States_of { node; count } -> Step.Block.run count c.structs.(node)
  | Running_mode -> running_mode c.program.nodes.(k)
  | Component _ -> Step.Block.foreign
  | Modes modes ->
      let mode m = snd (members c k (Step.State.fields_of_mode m)) in
      Step.Block.of_alternatives (List.map mode modes)

(* The members of a struct with these fields, and its size and alignment. *)
and members c k fields =
  let blocks = Long_list.map (block c k) fields in
  let offsets, whole = Step.Block.of_members blocks in
  let rec placed (fields : M.field list) offsets blocks found =
    match (fields, offsets, blocks) with
    | field :: fields, offset :: offsets, (room : Step.Block.t) :: blocks ->
        let holds = content c k field in
        let member = { name = field.name; offset; bytes = room.bytes; holds; span = field.span } in
        placed fields offsets blocks (member :: found)
    | _, _, _ -> List.rev found
  in
  (placed fields offsets blocks [], whole)

and content c k (field : M.field) =
  match field.content with
  | Value _ -> Value field.purpose
  | State_of node -> Struct node
  | States_of { node; count } -> Structs { node; count }
  | Running_mode -> Running_mode
  | Component symbol -> Value (Printf.sprintf "`struct %s_state`" symbol)
  | Modes modes -> Largest (List.map (alternative c k) modes)

and alternative c k (mode : M.mode) =
  let members, room = members c k (Step.State.fields_of_mode mode) in
  let name = c.program.nodes.(mode.node).origin in
  { mode = name; node = mode.node; bytes = room.bytes; members }

let of_program (program : M.program) =
  let count = Array.length program.nodes in
  let c = { program; structs = Array.make count { Step.Block.bytes = 0; alignment = 1 } } in
  let of_node k (node : M.node) =
    let members, room = members c k node.state in
    c.structs.(k) <- room;
    (* C does not allow structs without members. *)
    let bytes = if k = count - 1 then max 1 room.bytes else room.bytes in
    { name = node.origin; file = node.file; span = node.span; bytes; members }
  in
  Array.mapi of_node program.nodes

let in_use t =
  let seen = Array.make (Array.length t) false in
  let rec visit found k =
    if seen.(k) then found
    else (
      seen.(k) <- true;
      List.fold_left inside (k :: found) t.(k).members)
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
  bytes
  - List.fold_left (fun sum (member : member) -> Saturating_int.add sum member.bytes) 0 members

let foreign (program : M.program) =
  let rec of_value found (ty : M.ty) =
    match ty with
    | Foreign { c_type; copyable = true; _ } -> c_type :: found
    | Foreign _ | Bool | Int | Float | Nanoseconds -> found
    | Array (_, element) -> of_value found element
    | Sum k ->
        List.fold_left
          (fun found (ty, _) -> of_value found (Step.Layout.ty ty))
          found (Step.Layout.sum program.sums k).arrays
  in
  let rec of_field found (f : M.field) =
    match f.content with
    | Value ty -> of_value found ty
    | Component symbol -> Printf.sprintf "struct %s_state" symbol :: found
    | Modes modes ->
        List.fold_left
          (fun found m -> List.fold_left of_field found (Step.State.fields_of_mode m))
          found modes
    | State_of _ | States_of _ | Running_mode -> found
  in
  let of_node found (node : M.node) = List.fold_left of_field found node.state in
  List.sort_uniq String.compare (Array.fold_left of_node [] program.nodes)

(* The members are in source order. *)
let params_bytes (program : Step.Ir.program) =
  let size (p : Flow.Ir.param) =
    match p.param_ty with Bool -> 1 | Int -> 4 | _ -> Basis.Real.bytes program.real
  in
  let up bytes alignment = (bytes + alignment - 1) / alignment * alignment in
  let sizes = List.map size program.params in
  let add bytes size = up bytes size + size in
  up (List.fold_left add 0 sizes) (List.fold_left max 1 sizes)
