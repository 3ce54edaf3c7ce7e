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

type context = { program : M.program; apart : Machine.Apart.t }

(* The members of a struct with these fields, and its room. *)
let rec members c k fields =
  let blocks = Long_list.map (Machine.Apart.block c.apart k) fields in
  let offsets, whole = Machine.Block.of_members blocks in
  let member (placed, fields, offsets) (room : Machine.Block.t) =
    match (fields, offsets) with
    | (((field : M.field), _) as part) :: fields, offset :: offsets ->
        let holds = content c k part in
        ( { name = field.name; offset; bytes = room.bytes; holds; span = field.span } :: placed,
          fields,
          offsets )
    | _, _ -> (placed, fields, offsets)
  in
  let placed, _, _ = List.fold_left member ([], fields, offsets) blocks in
  (List.rev placed, whole.bytes)

and content c k ((field : M.field), (part : Machine.Apart.part)) =
  let struct_of node =
    if part = Small && Machine.Apart.is_split c.apart node then Array.length c.program.nodes + node
    else node
  in
  match field.content with
  | Value _ -> Value field.purpose
  | State_of node -> Struct (struct_of node)
  | States_of { node; count } -> Structs { node = struct_of node; count }
  | Running_mode -> Running_mode
  | Component symbol -> Value (Printf.sprintf "`struct %s_state`" symbol)
  | Modes modes -> Largest (List.map (alternative c k part) modes)

and alternative c k part (mode : M.mode) =
  let fields = Machine.Apart.in_order c.apart k (Machine.State.fields_of_mode mode) in
  let members, bytes = members c k (List.filter (fun (_, p) -> p = part) fields) in
  { mode = c.program.nodes.(mode.node).origin; node = mode.node; bytes; members }

let of_program (program : M.program) =
  let count = Array.length program.nodes in
  let c = { program; apart = Machine.Apart.of_program program } in
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
    let members, bytes = members c k large and small_members, small_bytes = members c k small in
    (* C has no struct without members. *)
    let bytes = if k = count - 1 then max 1 bytes else bytes in
    ( definition node node.origin bytes members,
      definition node (node.origin ^ ", small fields") small_bytes small_members )
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
