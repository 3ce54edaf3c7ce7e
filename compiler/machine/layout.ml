type slots = { floats : int; ints : int; bools : int; tags : int }

let none = { floats = 0; ints = 0; bools = 0; tags = 0 }

let combine f a b =
  {
    floats = f a.floats b.floats;
    ints = f a.ints b.ints;
    bools = f a.bools b.bools;
    tags = f a.tags b.tags;
  }

let add = combine ( + )

let shape_leaves shape =
  (* From the last leaf to the first, so that nothing needs reversing. *)
  let rec prepend (shape : Flow.Ir.shape) rest =
    match shape with
    | Leaf ty -> ty :: rest
    | Product { parts; _ } ->
        List.fold_left (fun rest (_, part) -> prepend part rest) rest (List.rev parts)
  in
  prepend shape []

let leaves (c : Flow.Ir.sum_constructor) =
  List.concat_map (fun (_, shape) -> shape_leaves shape) c.fields

let rec leaf sums (ty : Flow.Ir.ty) =
  match ty with
  | Float -> { none with floats = 1 }
  | Int -> { none with ints = 1 }
  | Bool -> { none with bools = 1 }
  | Sum k -> add { none with tags = 1 } (sum sums k)

and sum sums k =
  List.fold_left
    (fun most constructor ->
      let needs = List.fold_left (fun n ty -> add n (leaf sums ty)) none (leaves constructor) in
      combine max most needs)
    none sums.(k).Flow.Ir.constructors

let alignment sums (ty : Ir.ty) =
  match ty with
  | Bool -> 1
  | Int -> 4
  | Float | Nanoseconds -> 8
  | Sum k ->
      let slots = sum sums k in
      if slots.floats > 0 then 8 else if slots.ints > 0 then 4 else 1
