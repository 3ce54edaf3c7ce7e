type part = Large | Small

(* The largest alignment below 8 of what is no larger; 0 where there is nothing. *)
type room = { large : bool; small : int }

type t = {
  program : Ir.program;
  split : bool array;
  divided : bool array;  (** its members are large or small, but its own struct is one *)
  rooms : room array;  (** of states *)
  structs : Block.t array;
  small_structs : Block.t array;  (** of those that are split *)
}

let nothing = { large = false; small = 0 }
let union a b = { large = a.large || b.large; small = max a.small b.small }
let of_alignment n = if n >= 8 then { large = true; small = 0 } else { large = false; small = n }
let is_split t k = t.split.(k)
let has_both room = room.large && room.small > 0

let rec room t (content : Ir.content) =
  match content with
  | Value ty -> of_alignment (Layout.alignment t.program.real t.program.sums ty)
  | Running_mode -> of_alignment 1
  | Component _ -> of_alignment Layout.largest_alignment
  | State_of k | States_of { node = k; _ } -> t.rooms.(k)
  | Modes modes ->
      let of_mode mode = of_fields t (State.fields_of_mode mode) in
      List.fold_left (fun all mode -> union all (of_mode mode)) nothing modes

and of_fields t fields =
  List.fold_left (fun all (field : Ir.field) -> union all (room t field.content)) nothing fields

(* Is that two members? *)
let comes_apart t (content : Ir.content) =
  match content with
  | Value _ | Running_mode | Component _ -> false
  | State_of k | States_of { node = k; _ } -> t.split.(k)
  | Modes _ -> has_both (room t content)

let rec nodes_in (content : Ir.content) =
  match content with
  | State_of k | States_of { node = k; _ } -> [ k ]
  | Modes modes ->
      List.concat_map
        (fun mode -> List.concat_map (fun (f : Ir.field) -> nodes_in f.content) (State.fields_of_mode mode))
        modes
  | Value _ | Running_mode | Component _ -> []

let holds (node : Ir.node) = List.concat_map (fun (f : Ir.field) -> nodes_in f.content) node.state

let holds_as_modes (node : Ir.node) =
  let of_field (f : Ir.field) =
    match f.content with
    | Modes _ -> nodes_in f.content
    | Value _ | State_of _ | States_of _ | Running_mode | Component _ -> []
  in
  List.concat_map of_field node.state

(* {1 What is kept apart} *)

type extent =
  | Nowhere
  | Within_machines  (** machines within the root's, with all around and in them *)
  | All_machines  (** the root's own as well *)

let in_reach (program : Ir.program) extent =
  let count = Array.length program.nodes in
  let inner = Array.map holds program.nodes in
  let has_machine = Array.make count false and found = Array.make count false in
  let note k (node : Ir.node) =
    has_machine.(k) <- node.modes <> [] || List.exists (Array.get has_machine) inner.(k)
  in
  if extent <> Nowhere then (
    Array.iteri note program.nodes;
    let root = count - 1 in
    let reach = List.iter (fun inside -> found.(inside) <- true) in
    if extent = All_machines && program.nodes.(root).modes <> [] then (
      found.(root) <- true;
      reach (holds_as_modes program.nodes.(root)));
    for k = root - 1 downto 0 do
      if has_machine.(k) then found.(k) <- true;
      if found.(k) then reach inner.(k)
    done);
  found

(* The root has the small parts of those that it holds in its own struct. *)
let parts t k (field : Ir.field) =
  if not (t.split.(k) || t.divided.(k)) then [ Large ]
  else
    let room = room t field.content in
    if has_both room && (t.split.(k) || comes_apart t field.content) then [ Large; Small ]
    else if room.large then [ Large ]
    else [ Small ]

let in_order t k fields =
  let small (field : Ir.field) = (room t field.content).small in
  let of_part part = List.filter (fun field -> List.mem part (parts t k field)) fields in
  let smaller_last = List.stable_sort (fun a b -> compare (small b) (small a)) (of_part Small) in
  List.map (fun field -> (field, Large)) (of_part Large)
  @ List.map (fun field -> (field, Small)) smaller_last

(* {1 Its bytes} *)

(* The number of a mode is a byte while that is enough. *)
let running_mode (node : Ir.node) : Block.t =
  if List.compare_length_with node.modes 256 <= 0 then { bytes = 1; alignment = 1 }
  else { bytes = 4; alignment = 4 }

let only part = List.filter (fun (_, of_field) -> of_field = part)

let rec block t k ((field : Ir.field), part) =
  (* What has one struct has that one, be it of small fields only. *)
  let struct_of node =
    if part = Small && t.split.(node) then t.small_structs.(node) else t.structs.(node)
  in
  match field.content with
  | Value ty -> Block.of_value t.program.real t.program.sums ty
  | State_of node -> struct_of node
  | States_of { node; count } -> Block.run count (struct_of node)
  | Running_mode -> running_mode t.program.nodes.(k)
  | Component _ -> Block.foreign
  | Modes modes ->
      let of_mode mode = struct_block t k (only part (in_order t k (State.fields_of_mode mode))) in
      Block.of_alternatives (List.map of_mode modes)

and struct_block t k members = snd (Block.of_members (List.map (block t k) members))

let with_extent (program : Ir.program) extent =
  let count = Array.length program.nodes in
  let reached = in_reach program extent in
  let none : Block.t = { bytes = 0; alignment = 1 } in
  let t =
    {
      program;
      split = Array.make count false;
      divided = Array.make count false;
      rooms = Array.make count nothing;
      structs = Array.make count none;
      small_structs = Array.make count none;
    }
  in
  Array.iteri
    (fun k (node : Ir.node) ->
      let room = of_fields t node.state in
      let is_root = k = count - 1 in
      let split = reached.(k) && has_both room && Option.is_none node.foreign && not is_root in
      t.split.(k) <- split;
      t.divided.(k) <- (is_root && reached.(k)) || List.exists (Array.get t.split) (holds node);
      t.rooms.(k) <- (if split || not room.large then room else { large = true; small = 0 });
      let members = in_order t k node.state in
      let large, small = if split then (only Large members, only Small members) else (members, []) in
      t.structs.(k) <- struct_block t k large;
      t.small_structs.(k) <- struct_block t k small)
    program.nodes;
  t

let of_program (program : Ir.program) =
  let bytes t = t.structs.(Array.length program.nodes - 1).bytes in
  let smaller best extent =
    let other = with_extent program extent in
    if bytes other < bytes best then other else best
  in
  if Array.exists (fun (node : Ir.node) -> node.modes <> []) program.nodes then
    List.fold_left smaller (with_extent program All_machines) [ Within_machines; Nowhere ]
  else with_extent program Nowhere
