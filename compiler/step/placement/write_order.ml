open Basis
open Fragment

type write = { write : Fragment.write; early : bool }

let reads usage atoms =
  let fields = Int_table.create 8 and seen = Int_table.create 8 in
  let rec visit = function
    | [] -> ()
    | [] :: rest -> visit rest
    | (atom :: atoms) :: rest -> (
        let rest = atoms :: rest in
        match (atom : atom) with
        | Bool _ | Int _ | Float _ -> visit rest
        | Signal s -> (
            match Usage.leaf usage s with
            | Some (Field field) ->
                Int_table.replace fields field.id ();
                visit rest
            | Some _ -> visit rest
            | None -> (
                match Usage.item_of usage s with
                | Some (_, Action { always = true; _ }) | None -> visit rest
                | Some (k, (Computed { operands; _ } | Action { operands; _ })) ->
                    let times = 1 + Option.value (Int_table.find_opt seen k) ~default:0 in
                    Int_table.replace seen k times;
                    if times = Usage.item_uses usage k then visit (operands :: rest) else visit rest
                )))
  in
  visit [ atoms ];
  fields

let overlap a b = Int_table.fold (fun field () any -> any || Int_table.mem b field) a false

let note written (w : Fragment.write) =
  match w.place with Own field -> Int_table.replace written field.id () | Local _ | Result _ -> ()

(* Groups consecutive writes with the same condition, which share an [If]. *)
let groups writes =
  let condition (w : Fragment.write) =
    match w.update with Branch { condition = Signal c; _ } -> Some c.id | _ -> None
  in
  let add groups (w : Fragment.write) =
    match groups with
    | (first :: _ as group) :: others when condition w <> None && condition first = condition w ->
        (w :: group) :: others
    | _ -> [ w ] :: groups
  in
  List.rev_map List.rev (List.fold_left add [] writes)

let of_usage usage =
  let written = Int_table.create 16 in
  let needs_written writes =
    let atoms (w : Fragment.write) = Usage.update_atoms w.update in
    overlap (reads usage (List.concat_map atoms writes)) written
  in
  (* The values that a group of several writes needs are computed in its [If], before all these
     writes. *)
  let order group =
    let all_early = List.compare_length_with group 1 > 0 && needs_written group in
    let one (write : Fragment.write) =
      let early = all_early || needs_written [ write ] in
      note written write;
      { write; early }
    in
    Long_list.map one group
  in
  List.concat_map order (groups (Usage.writes usage))

let written writes value usage =
  let fields = Int_table.create 16 in
  List.iter (fun w -> note fields w.write) writes;
  overlap (reads usage [ value ]) fields
