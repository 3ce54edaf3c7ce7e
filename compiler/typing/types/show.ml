open Type_text

let unit_ (u : Ir.unit_) =
  product (List.map (fun ((v : Ir.variable), p) -> (v.name, p)) u.variables @ base_names u.base)

let rec tree : Ir.ty -> Type_text.tree = function
  | Variable v -> Word v.name
  | Number (Int, u) -> Word (number (`Named "Int") (unit_ u))
  | Number (Float, u) -> Word (number (`Named "Float") (unit_ u))
  | Number (Representation_variable v, u) -> Word (number (`Variable v.name) (unit_ u))
  | Bool -> Word "Bool"
  | String -> Word "String"
  | Size n -> Word (string_of_int n)
  | Tuple elements -> Group (List.map tree elements)
  | Function (a, b) ->
      let a = tree a in
      Arrow (a, tree b)
  | Signal_function (a, b) -> Applied ("SF", [ tree a; tree b ])
  | Data { tycon; units; arguments } ->
      applied (bracketed tycon.name (List.map unit_ units)) (List.map tree arguments)

let ty t = write (tree t)
let class_ : Ir.class_ -> string = function Eq -> "Eq" | Ord -> "Ord" | Declared c -> c.name
let final_constraint c t = write (Applied (class_ c, [ tree t ]))

let scheme (s : Ir.scheme) =
  let constraint_ (c, t) = final_constraint c t in
  let body = ty s.ty in
  match s.context with
  | [] -> body
  | [ one ] -> constraint_ one ^ " => " ^ body
  | several -> "(" ^ String.concat ", " (List.map constraint_ several) ^ ") => " ^ body
