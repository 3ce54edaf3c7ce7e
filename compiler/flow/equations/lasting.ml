let rec of_the_instant (sums : Ir.sum array) (ty : Ir.ty) =
  match ty with
  | Bool | Int | Float | Foreign { copyable = true; _ } -> None
  | Foreign f -> Some f
  | Array (_, element) -> of_the_instant sums element
  | Sum k -> List.find_map (of_constructor sums) sums.(k).constructors

and of_constructor sums c = List.find_map (fun (_, shape) -> of_shape sums shape) c.fields

and of_shape sums : Ir.shape -> Ir.foreign_type option = function
  | Leaf ty -> of_the_instant sums ty
  | Product { parts; _ } -> List.find_map (fun (_, shape) -> of_shape sums shape) parts
  | Repeated (_, shape) -> of_shape sums shape

let rec mentions_foreign sums : Ir.shape -> bool = function
  | Leaf ty -> is_foreign sums ty
  | Product { parts; _ } -> List.exists (fun (_, shape) -> mentions_foreign sums shape) parts
  | Repeated (_, shape) -> mentions_foreign sums shape

and is_foreign (sums : Ir.sum array) (ty : Ir.ty) =
  match ty with
  | Foreign _ -> true
  | Bool | Int | Float -> false
  | Array (_, element) -> is_foreign sums element
  | Sum k ->
      List.exists
        (fun (c : Ir.sum_constructor) ->
          List.exists (fun (_, shape) -> mentions_foreign sums shape) c.fields)
        sums.(k).constructors
