type table = {
  types : Types.table;
  limit : int;
  counts : int Variables.Table.t; (* counts, by the identity of the closure; see [in_closure] *)
}

let table types ~limit = { types; limit; counts = Variables.Table.create 256 }

(* The number of constants inside the functions of a value, capped at the limit plus one. A function
   that occurs twice counts twice. *)
let rec in_value table ~inside ty (value : Value.t) =
  let layout = Types.layout table.types ty in
  if layout.first_order then
    if inside then List.length (List.filter is_number (Leaves.known table.types ty value)) else 0
  else
    match (value, layout.kind) with
    | Product values, Product parts -> in_parts table ~inside parts (Array.to_list values)
    | Elements values, Array (_, element) ->
        List.fold_left (fun sum value -> sum + in_value table ~inside element value) 0 values
    | Constructed { constructor; arguments }, Sum fields ->
        in_parts table ~inside fields.(constructor) arguments
    | (Function closure | Signal_function closure), _ -> in_closure table closure
    | Primitive { arguments; _ }, _ ->
        let argument (a : Value.argument) = in_value table ~inside:true a.ty a.value in
        List.fold_left (fun sum a -> sum + argument a) 0 arguments
    | Choice { then_; else_; _ }, _ ->
        in_value table ~inside ty then_ + in_value table ~inside ty else_
    | Program signal_function, _ -> in_value table ~inside ty signal_function
    | (Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Unspecified), _ -> 0

and is_number : Flow.Ir.atom option -> bool = function
  | Some (Bool _ | Int _ | Float _) -> true
  | Some (Signal _) | None -> false

and in_parts table ~inside parts values =
  List.fold_left2
    (fun sum (part : Types.part) value -> sum + in_value table ~inside part.ty value)
    0 parts values

and in_closure table closure =
  match Variables.Table.find_opt table.counts closure.identity with
  | Some known -> known
  | None ->
      let count = in_captured table ~inside:true closure in
      Variables.Table.replace table.counts closure.identity count;
      count

and in_captured table ~inside (closure : Value.closure) =
  Variables.fold
    (fun _ (entry : Value.entry) sum ->
      if sum > table.limit then sum
      else sum + in_value table ~inside entry.local_ty (Closure.forced entry))
    closure.captured 0
  |> min (table.limit + 1)

let are_many table closure = in_captured table ~inside:false closure > table.limit
