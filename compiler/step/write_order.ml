open Basis
open Fragment

type unit_ = {
  writes : writes;
  early : bool;
}

and writes =
  | Always of write
  | By of { condition : Fragment.atom; then_ : write list; else_ : write list; span : Span.t }

and write = {
  write : Fragment.write;
  early : bool;
}

let atoms update =
  let rec prepend update rest =
    match update with
    | Keep -> rest
    | Set atom -> atom :: rest
    | Branch { condition; then_; else_ } -> condition :: prepend then_ (prepend else_ rest)
  in
  prepend update []

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

(* Orders [count] things by Kahn's method, the first ready one first.
   [reads k] and [writes k] are fields. Returns the order, and which things
   had to be made early to break a circle. *)
let sequence ~count ~reads ~writes =
  let early = Array.make count false and finished = Array.make count false in
  let writer = Int_table.create 16 and waits = Array.make count 0 in
  for k = 0 to count - 1 do
    List.iter (fun field -> Int_table.replace writer field k) (writes k)
  done;
  (* The things that must wait for k, because k reads what they write. *)
  let blocked =
    Array.init count (fun k ->
        let fields = List.sort compare (Int_table.fold (fun f () l -> f :: l) (reads k) []) in
        List.filter (fun other -> other <> k) (List.filter_map (Int_table.find_opt writer) fields))
  in
  Array.iter (List.iter (fun other -> waits.(other) <- waits.(other) + 1)) blocked;
  let module Ready = Set.Make (Int) in
  let release k ready =
    List.fold_left
      (fun ready other ->
        waits.(other) <- waits.(other) - 1;
        if waits.(other) = 0 && not finished.(other) then Ready.add other ready else ready)
      ready blocked.(k)
  in
  let rec go ready next order =
    match Ready.min_elt_opt ready with
    | Some k ->
        finished.(k) <- true;
        let ready = Ready.remove k ready in
        go (if early.(k) then ready else release k ready) next (k :: order)
    | None ->
        if next = count then List.rev order
        else if finished.(next) || early.(next) then go ready (next + 1) order
        else (
          early.(next) <- true;
          go (release next ready) (next + 1) order)
  in
  let ready = ref Ready.empty in
  for k = 0 to count - 1 do
    if waits.(k) = 0 then ready := Ready.add k !ready
  done;
  let order = go !ready 0 [] in
  (order, early)

let written (w : Fragment.write) =
  match w.place with Own field -> [ field.id ] | Local _ | Result _ -> []

let order_block usage writes =
  let writes = Array.of_list writes in
  let order, early =
    sequence ~count:(Array.length writes)
      ~reads:(fun k -> reads usage (atoms writes.(k).Fragment.update))
      ~writes:(fun k -> written writes.(k))
  in
  Long_list.map (fun k -> { write = writes.(k); early = early.(k) }) order

(* Units under construction: writes of each branch, last first. *)
type building =
  | One of Fragment.write
  | Many of {
      condition : atom;
      span : Span.t;
      mutable first : Fragment.write list;
      mutable second : Fragment.write list;
    }

let gather writes =
  let by_condition = Int_table.create 16 in
  let extend building first second =
    match building with
    | One _ -> ()
    | Many unit_ ->
        unit_.first <- first @ unit_.first;
        unit_.second <- second @ unit_.second
  in
  let add units (w : Fragment.write) =
    match w.update with
    | Branch { condition = Signal c as condition; then_; else_ } -> (
        let branch update = match update with Keep -> [] | Set _ | Branch _ -> [ { w with update } ] in
        let first = branch then_ and second = branch else_ in
        match Int_table.find_opt by_condition c.id with
        | Some building ->
            extend building first second;
            units
        | None ->
            let building = Many { condition; span = w.span; first; second } in
            Int_table.replace by_condition c.id building;
            building :: units)
    | Keep | Set _ | Branch _ -> One w :: units
  in
  Array.of_list (List.rev (List.fold_left add [] writes))

let all = function One w -> [ w ] | Many { first; second; _ } -> List.rev_append first second

let values building =
  let condition = match building with One _ -> [] | Many { condition; _ } -> [ condition ] in
  condition @ List.concat_map (fun (w : Fragment.write) -> atoms w.update) (all building)

let of_usage usage =
  let units = gather (Usage.writes usage) in
  let order, early =
    sequence ~count:(Array.length units)
      ~reads:(fun k -> reads usage (values units.(k)))
      ~writes:(fun k -> List.concat_map written (all units.(k)))
  in
  let unit_ k =
    let writes =
      match units.(k) with
      | One write -> Always { write; early = false }
      | Many { condition; span; first; second } ->
          let block writes = order_block usage (List.rev writes) in
          By { condition; span; then_ = block first; else_ = block second }
    in
    { writes; early = early.(k) }
  in
  Long_list.map unit_ order
