type t = Fact.size = { variable : string; of_ : string; array : string option }

(* The size variables in the type of the array [xs], each with an expression for an array of that
   size. *)
let of_array (ty : Ir.ty) xs =
  let variable (ty : Ir.ty) array =
    match ty.desc with Type_variable n -> [ (n, array) ] | _ -> []
  in
  match ty.desc with
  | Named { tycon = { name = "Array"; _ }; arguments = n :: _; _ }
  | Named { tycon = { module_ = "Matrix"; name = "Vector" }; arguments = [ n ]; _ } ->
      variable n xs
  | Named { tycon = { module_ = "Matrix"; name = "Matrix" }; arguments = [ r; c ]; _ } ->
      variable r xs @ variable c (Printf.sprintf "(%s ! 0)" xs)
  | _ -> []

let rec size_variables (ty : Ir.ty) =
  List.map fst (of_array ty "")
  @
  match ty.desc with
  | Named { arguments; _ } | Tuple_type arguments -> List.concat_map size_variables arguments
  | Function (a, b) -> size_variables a @ size_variables b
  | Type_variable _ | Representation _ | Size _ -> []

let rec arrays (ty : Ir.ty) (parameters : Ir.pattern list) =
  match (ty.desc, parameters) with
  | Function (a, rest), { desc = Bound local | As (local, _); _ } :: others ->
      of_array a local.name @ arrays rest others
  | Function (_, rest), _ :: others -> arrays rest others
  | _ -> []

let of_signature ~name (scheme : Ir.scheme) parameters =
  let arrays = arrays scheme.ty parameters in
  let size variable = { variable; of_ = name; array = List.assoc_opt variable arrays } in
  List.map size (List.sort_uniq String.compare (size_variables scheme.ty))

let find sizes name = List.find_opt (fun size -> String.equal size.variable name) sizes
