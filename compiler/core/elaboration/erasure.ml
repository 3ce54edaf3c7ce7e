let boolean : Ir.Global.t = { module_ = "Prelude"; name = "Bool" }
let array : Ir.Global.t = { module_ = "Prelude"; name = "Array" }
let variable (v : Typing.Ir.variable) : Ir.variable = { id = v.id; name = v.name }

let representation : Typing.Ir.representation -> Ir.ty = function
  | Int -> Int
  | Float -> Float
  | Representation_variable v -> Variable (variable v)

let rec ty : Typing.Ir.ty -> Ir.ty = function
  | Variable v -> Variable (variable v)
  | Number (r, _) -> representation r
  | Bool -> Bool
  | String -> String
  | Tuple ts -> Tuple (tys ts)
  | Function (a, b) -> Function (ty a, ty b)
  | Signal_function (a, b) -> Signal_function (ty a, ty b)
  | Size n -> Size n
  | Data { tycon; units = _; arguments = [ size; element ] } when tycon = array ->
      Array (ty size, ty element)
  | Data { tycon; units = _; arguments } -> Data (tycon, tys arguments)

and tys ts = Basis.Long_list.map ty ts

let instantiation (i : Typing.Ir.instantiation) =
  match (i.types, i.representations) with
  | [], [] -> []
  | types, representations -> tys types @ List.map representation representations

let parameters (s : Typing.Ir.scheme) = List.map variable (s.types @ s.representations)

let rec substitute by : Ir.ty -> Ir.ty = function
  | Variable v as t -> (
      match List.find_opt (fun ((w : Ir.variable), _) -> w.id = v.id) by with
      | Some (_, t) -> t
      | None -> t)
  | (Bool | Int | Float | String | Size _) as t -> t
  | Tuple ts -> Tuple (substitutes by ts)
  | Function (a, b) -> Function (substitute by a, substitute by b)
  | Signal_function (a, b) -> Signal_function (substitute by a, substitute by b)
  | Data (tycon, ts) -> Data (tycon, substitutes by ts)
  | Array (size, element) -> Array (substitute by size, substitute by element)

and substitutes by ts = Basis.Long_list.map (substitute by) ts
