type part = Large | Small

(* The largest alignment below 8 of what is no larger; 0 where there is nothing. *)
type room = { large : bool; small : int }

type t = {
  program : Ir.program;
  split : bool array;
  around : bool array;  (** it holds one that is split *)
  rooms : room array;  (** of states *)
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

let rec holds_split t (content : Ir.content) =
  match content with
  | Value _ | Running_mode | Component _ -> false
  | State_of k | States_of { node = k; _ } -> t.split.(k)
  | Modes modes ->
      List.exists
        (fun mode ->
          List.exists (fun (f : Ir.field) -> holds_split t f.content) (State.fields_of_mode mode))
        modes

let holds (node : Ir.node) =
  let rec content (c : Ir.content) =
    match c with
    | State_of k | States_of { node = k; _ } -> [ k ]
    | Modes modes ->
        List.concat_map
          (fun mode -> List.concat_map (fun (f : Ir.field) -> content f.content) (State.fields_of_mode mode))
          modes
    | Value _ | Running_mode | Component _ -> []
  in
  List.concat_map (fun (f : Ir.field) -> content f.content) node.state

(* Machines within the root's, with all around and in them. *)
let around_or_in_machines (program : Ir.program) =
  let count = Array.length program.nodes in
  let inner = Array.map holds program.nodes in
  let has_machine = Array.make count false and found = Array.make count false in
  Array.iteri
    (fun k (node : Ir.node) ->
      has_machine.(k) <- node.modes <> [] || List.exists (Array.get has_machine) inner.(k))
    program.nodes;
  for k = count - 2 downto 0 do
    if has_machine.(k) then found.(k) <- true;
    if found.(k) then List.iter (fun inside -> found.(inside) <- true) inner.(k)
  done;
  found

let of_program (program : Ir.program) =
  let count = Array.length program.nodes in
  let worth = around_or_in_machines program in
  let t =
    {
      program;
      split = Array.make count false;
      around = Array.make count false;
      rooms = Array.make count nothing;
    }
  in
  Array.iteri
    (fun k (node : Ir.node) ->
      let room = of_fields t node.state in
      let split = worth.(k) && has_both room && Option.is_none node.foreign in
      t.split.(k) <- split;
      t.around.(k) <- List.exists (Array.get t.split) (holds node);
      t.rooms.(k) <- (if split || not room.large then room else { large = true; small = 0 }))
    program.nodes;
  t

(* The root has the small parts of those that it holds in its own struct. *)
let parts t k (field : Ir.field) =
  if not (t.split.(k) || t.around.(k)) then [ Large ]
  else
    let room = room t field.content in
    if has_both room && (t.split.(k) || holds_split t field.content) then [ Large; Small ]
    else if room.large then [ Large ]
    else [ Small ]

let in_order t k fields =
  let small (field : Ir.field) = (room t field.content).small in
  let of_part part = List.filter (fun field -> List.mem part (parts t k field)) fields in
  let smaller_last = List.stable_sort (fun a b -> compare (small b) (small a)) (of_part Small) in
  List.map (fun field -> (field, Large)) (of_part Large)
  @ List.map (fun field -> (field, Small)) smaller_last
