let singular word =
  let n = String.length word in
  if n > 3 && word.[n - 1] = 's' then String.sub word 0 (n - 1) else word

let symbol word =
  match singular (String.lowercase_ascii word) with
  | "meter" | "metre" | "mtr" -> Some "m"
  | "centimeter" | "centimetre" -> Some "cm"
  | "millimeter" | "millimetre" -> Some "mm"
  | "kilometer" | "kilometre" -> Some "km"
  | "sec" | "second" -> Some "s"
  | "msec" | "millisecond" -> Some "ms"
  | "minute" -> Some "min"
  | "h" | "hr" -> Some "hour"
  | "kilogram" -> Some "kg"
  | "gram" -> Some "g"
  | "radian" -> Some "rad"
  | "degree" -> Some "deg"
  | "hertz" -> Some "Hz"
  | "volt" -> Some "V"
  | "ampere" | "amp" -> Some "A"
  | "newton" -> Some "N"
  | "watt" -> Some "W"
  | "kelvin" -> Some "K"
  | "mps" -> Some "m/s"
  | "kmh" | "kph" | "kmph" -> Some "km/hour"
  | "dps" -> Some "deg/s"
  | "pixel" -> Some "px"
  | "bpm" -> Some "1/min"
  | "rps" -> Some "rad/s"
  | _ -> None

let rec is_expression is_unit (e : Syntax.Ir.expr) =
  match e.desc with
  | Variable { qualifier = None; name; _ } -> is_unit name
  | Constructor { qualifier = None; name; _ } -> is_unit name
  | Binary { operator = { name = { text = "/" | "*"; _ }; _ }; left; right } ->
      let is_one = match left.desc with Number { digits = "1"; _ } -> true | _ -> false in
      (is_one || is_expression is_unit left) && is_expression is_unit right
  | Power { base; _ } | Parenthesized base -> is_expression is_unit base
  | _ -> false

let rec of_expression (e : Syntax.Ir.expr) =
  match e.desc with
  | Variable { name; _ } | Constructor { name; _ } -> name.text
  | Number { digits; _ } -> digits
  | Binary { operator; left; right } ->
      of_expression left ^ operator.name.text ^ of_expression right
  | Power { base; exponent } -> Printf.sprintf "%s^%d" (of_expression base) exponent
  | Parenthesized inner -> "(" ^ of_expression inner ^ ")"
  | _ -> "…"
