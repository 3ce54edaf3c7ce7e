let leaves shape =
  (* Goes from the last leaf to the first, so that no list needs to be reversed. *)
  let rec prepend (shape : Ir.shape) rest =
    match shape with
    | Leaf ty -> ty :: rest
    | Product { parts; _ } ->
        List.fold_left (fun rest (_, part) -> prepend part rest) rest (List.rev parts)
    | Repeated (n, element) ->
        let array leaf : Ir.ty = Array (n, leaf) in
        List.rev_append (List.rev_map array (prepend element [])) rest
  in
  prepend shape []

let split shapes all =
  let take rest shape =
    let own, rest = Basis.Long_list.split_at (List.length (leaves shape)) rest in
    (rest, own)
  in
  snd (List.fold_left_map take all shapes)

let payload (c : Ir.sum_constructor) = List.concat_map (fun (_, shape) -> leaves shape) c.fields

let rec foreign (sums : Ir.sum array) (ty : Ir.ty) =
  match ty with
  | Bool | Int | Float -> []
  | Foreign f -> [ f ]
  | Array (_, element) -> foreign sums element
  | Sum k ->
      List.concat_map (fun c -> List.concat_map (foreign sums) (payload c)) sums.(k).constructors

let of_the_instant sums ty =
  List.find_opt (fun (f : Ir.foreign_type) -> not f.copyable) (foreign sums ty)

let is_image (f : Ir.foreign_type) = String.equal f.c_type "struct frob_image" && not f.copyable

let for_hosts sums shape =
  List.for_all (fun ty -> List.for_all is_image (foreign sums ty)) (leaves shape)

let mentions_foreign sums shape = List.exists (fun ty -> foreign sums ty <> []) (leaves shape)
