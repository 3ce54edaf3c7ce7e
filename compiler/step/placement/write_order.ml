open Basis
open Fragment

type write = {
  write : Fragment.write;
  early : bool;
}

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
                    if times = Usage.item_uses usage k then visit (operands :: rest)
                    else visit rest)))
  in
  visit [ atoms ];
  fields

let overlap a b = Int_table.fold (fun field () any -> any || Int_table.mem b field) a false

let note written (w : Fragment.write) =
  match w.place with
  | Own field -> Int_table.replace written field.id ()
  | Local _ | Result _ -> ()

let of_usage usage =
  let written = Int_table.create 16 in
  let order (write : Fragment.write) =
    let early = overlap (reads usage (Usage.update_atoms write.update)) written in
    note written write;
    { write; early }
  in
  Long_list.map order (Usage.writes usage)

let written writes value usage =
  let fields = Int_table.create 16 in
  List.iter (fun w -> note fields w.write) writes;
  overlap (reads usage [ value ]) fields
