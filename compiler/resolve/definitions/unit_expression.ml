let rec is_unit is_name (e : Syntax.Ir.expr) =
  match e.desc with
  | Variable { qualifier = None; name; _ } -> is_name name
  | Constructor { qualifier = None; name; _ } -> is_name name
  | Binary { operator = { name = { text = "/" | "*"; _ }; _ }; left; right } ->
      let is_one = match left.desc with Number { digits = "1"; _ } -> true | _ -> false in
      (is_one || is_unit is_name left) && is_unit is_name right
  | Power { base; _ } | Parenthesized base -> is_unit is_name base
  | _ -> false
