open Basis
open State_layout
module M = Step.Ir

(* The state struct of each node. *)
type t = definition array

let root t = Array.length t - 1
let definition = Array.get

let rec placed (program : M.program) (members : Step.State_struct.member list) =
  let blocks = Long_list.map (fun (m : Step.State_struct.member) -> m.block) members in
  let offsets, whole = Step.Block.of_members blocks in
  let member offset (m : Step.State_struct.member) =
    let name = String.concat "." m.path in
    { name; offset; bytes = m.block.bytes; holds = content program m; span = m.field.span }
  in
  (List.rev (List.rev_map2 member offsets members), whole)

and content program (m : Step.State_struct.member) =
  match m.field.content with
  | Value _ -> Value m.field.purpose
  | State_of node -> Struct node
  | States_of { node; count } -> Structs { node; count }
  | Running_mode -> Running_mode
  | Component symbol -> Value (Printf.sprintf "`struct %s_state`" symbol)
  | Modes modes ->
      let alternative (number, members) =
        let { node; _ } : M.mode = List.nth modes number in
        let members, whole = placed program members in
        { mode = program.nodes.(node).origin; node; bytes = whole.bytes; members }
      in
      Largest (List.map alternative m.modes)

let of_program (program : M.program) =
  let structs = Step.State_struct.of_program program in
  let of_node k (node : M.node) =
    let members, whole = placed program (Step.State_struct.members structs k) in
    (* C does not allow structs without members. *)
    let bytes = if k = Array.length program.nodes - 1 then max 1 whole.bytes else whole.bytes in
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
