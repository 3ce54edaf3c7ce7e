type slots = {
  floats : int;
  ints : int;
  bools : int;
  tags : int;
  arrays : (Flow.Ir.ty * int) list; (* sorted *)
}

let none = { floats = 0; ints = 0; bools = 0; tags = 0; arrays = [] }

let rec merge f a b =
  match (a, b) with
  | [], rest | rest, [] -> rest
  | ((ty, n) as first) :: others_of_a, ((ty', m) as first') :: others_of_b ->
      let order = compare ty ty' in
      if order = 0 then (ty, f n m) :: merge f others_of_a others_of_b
      else if order < 0 then first :: merge f others_of_a b
      else first' :: merge f a others_of_b

let combine f a b =
  {
    floats = f a.floats b.floats;
    ints = f a.ints b.ints;
    bools = f a.bools b.bools;
    tags = f a.tags b.tags;
    arrays = merge f a.arrays b.arrays;
  }

let add = combine ( + )
let arrays_before slots ty = Option.value (List.assoc_opt ty slots.arrays) ~default:0

let rec ty : Flow.Ir.ty -> Ir.ty = function
  | Bool -> Bool
  | Int -> Int
  | Float -> Float
  | Sum k -> Sum k
  | Array (n, element) -> Array (n, ty element)
  | Foreign f -> Foreign f

let rec leaf sums (ty : Flow.Ir.ty) =
  match ty with
  | Float -> { none with floats = 1 }
  | Int -> { none with ints = 1 }
  | Bool -> { none with bools = 1 }
  | Sum k -> add { none with tags = 1 } (sum sums k)
  | Array _ | Foreign _ -> { none with arrays = [ (ty, 1) ] }

and sum sums k =
  List.fold_left
    (fun most constructor ->
      let add_leaf n ty = add n (leaf sums ty) in
      let needs = List.fold_left add_leaf none (Flow.Shape.payload constructor) in
      combine max most needs)
    none sums.(k).Flow.Ir.constructors
