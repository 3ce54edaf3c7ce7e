let result (operator : Ir.operator) (arguments : Ir.ty list) : Ir.ty option =
  match (operator, arguments) with
  | (Add | Subtract | Multiply | Minimum | Maximum), [ ((Int | Float) as a); b ] when a = b ->
      Some a
  | (Negate | Absolute | Signum), [ ((Int | Float) as a) ] -> Some a
  | (Equal | Less | Less_equal), [ ((Int | Float) as a); b ] when a = b -> Some Bool
  | Equal, [ Bool; Bool ] -> Some Bool
  | (Divide | Pow | Elementary (Hypot | Atan2)), [ Float; Float ] -> Some Float
  | Elementary f, [ Float ] when f <> Hypot && f <> Atan2 -> Some Float
  | (Div | Mod | Bitwise _), [ Int; Int ] -> Some Int
  | To_float, [ Int ] -> Some Float
  | (Round | Floor | Ceiling | Truncate), [ Float ] -> Some Int
  | Not, [ Bool ] -> Some Bool
  | (And | Or), [ Bool; Bool ] -> Some Bool
  | _, _ -> None
