open Basis
open Fragment

type timing = In_order | Early_condition | Early
type write = { write : Fragment.write; timing : timing }

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
  let need_written atoms writes =
    overlap
      (reads usage (List.concat_map (fun (w : Fragment.write) -> atoms w.update) writes))
      written
  in
  let all = Usage.update_atoms in
  let values : Fragment.update -> Fragment.atom list = function
    | Branch { condition = _; then_; else_ } -> List.append (all then_) (all else_)
    | update -> all update
  in
  (* If a group has several writes, the values that they need are computed in the group's [If],
     before all these writes. *)
  let order group =
    let all_early = List.compare_length_with group 1 > 0 && need_written values group in
    let early_condition = need_written all group && not (need_written values group) in
    let one (write : Fragment.write) =
      let needs = if early_condition then need_written values else need_written all in
      let early = all_early || needs [ write ] in
      note written write;
      {
        write;
        timing = (if early then Early else if early_condition then Early_condition else In_order);
      }
    in
    Long_list.map one group
  in
  List.concat_map order (groups (Usage.writes usage))

let written writes value usage =
  let fields = Int_table.create 16 in
  List.iter (fun w -> note fields w.write) writes;
  overlap (reads usage [ value ]) fields
