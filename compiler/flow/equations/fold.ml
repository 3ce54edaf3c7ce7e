open Ir

(* [x] must be an integer, an infinity or NaN. *)
let saturate x =
  if Float.is_nan x then 0l
  else if x >= 2147483647. then Int32.max_int
  else if x <= -2147483648. then Int32.min_int
  else Int32.of_float x

let shift a n = if n < 0 then a asr min 32 (-n) else a lsl min 32 n

let bitwise (operation : Core.Primitive.bitwise) a b =
  let on_wide f = Int32.of_int (f (Int32.to_int a) (Int32.to_int b)) in
  match operation with
  | Bit_and -> Int32.logand a b
  | Bit_or -> Int32.logor a b
  | Bit_xor -> Int32.logxor a b
  | Shift_left -> on_wide shift
  | Shift_right -> on_wide (fun a n -> shift a (-n))

let on_ints operator a b : Ir.atom option =
  let below = Int32.compare a b < 0 in
  match operator with
  | Add -> Some (Int (Int32.add a b))
  | Subtract -> Some (Int (Int32.sub a b))
  | Multiply -> Some (Int (Int32.mul a b))
  | Div -> Some (Int (Basis.Division.div a b))
  | Mod -> Some (Int (Basis.Division.mod_ a b))
  | Bitwise operation -> Some (Int (bitwise operation a b))
  | Equal -> Some (Bool (Int32.equal a b))
  | Less -> Some (Bool below)
  | Less_equal -> Some (Bool (below || Int32.equal a b))
  | Minimum -> Some (Int (if below then a else b))
  | Maximum -> Some (Int (if below then b else a))
  | Negate | Absolute | Signum | Divide | Pow | Elementary _ | To_float | Round | Floor | Ceiling
  | Truncate | Not | And | Or ->
      None

(* A quiet NaN. Before OCaml 5.1, [Float.nan] was a signalling NaN, which [pow] and other functions
   treat differently. *)
let nan = Int64.float_of_bits 0x7ff8_0000_0000_0000L

let elementary_of_one real (f : Core.Primitive.elementary) a =
  let module E = (val Elementary.of_precision real) in
  match f with
  | Sqrt -> Some (Basis.Real.round real (Float.sqrt a))
  | Floor_float -> Some (Float.floor a)
  | Ceiling_float -> Some (Float.ceil a)
  | Nanoseconds -> Some (Clock.nanoseconds real a)
  | Exp -> Some (E.exp a)
  | Log -> Some (E.log a)
  | Sin -> Some (E.sin a)
  | Cos -> Some (E.cos a)
  | Tan -> Some (E.tan a)
  | Asin -> Some (E.asin a)
  | Acos -> Some (E.acos a)
  | Atan -> Some (E.atan a)
  | Hypot | Atan2 -> None

let elementary_of_two real (f : Core.Primitive.elementary) a b =
  let module E = (val Elementary.of_precision real) in
  match f with
  | Hypot -> Some (E.hypot a b)
  | Atan2 -> Some (E.atan2 a b)
  | Sqrt | Floor_float | Ceiling_float | Nanoseconds | Exp | Log | Sin | Cos | Tan | Asin | Acos
  | Atan ->
      None

let constant x = Ir.Float (if Float.is_nan x then nan else x)

let on_floats real operator a b : Ir.atom option =
  let module E = (val Elementary.of_precision real) in
  let rounded x = Some (Ir.Float (Basis.Real.round real x)) in
  let nan_or x = Some (Float (if Float.is_nan a || Float.is_nan b then nan else x)) in
  match operator with
  | Add -> rounded (a +. b)
  | Subtract -> rounded (a -. b)
  | Multiply -> rounded (a *. b)
  | Divide -> rounded (a /. b)
  | Equal -> Some (Bool (a = b))
  | Less -> Some (Bool (a < b))
  | Less_equal -> Some (Bool (a <= b))
  | Minimum -> nan_or (if b < a then b else a)
  | Maximum -> nan_or (if b > a then b else a)
  | Pow -> Some (constant (E.pow a b))
  | Elementary f -> Option.map constant (elementary_of_two real f a b)
  | Negate | Absolute | Signum | Div | Mod | Bitwise _ | To_float | Round | Floor | Ceiling
  | Truncate | Not | And | Or ->
      None

let on_int real operator a : Ir.atom option =
  match operator with
  | Negate -> Some (Int (Int32.neg a))
  | Absolute -> Some (Int (Int32.abs a))
  | Signum -> Some (Int (Int32.of_int (Int32.compare a 0l)))
  | To_float -> Some (Float (Basis.Real.round real (Int32.to_float a)))
  | Add | Subtract | Multiply | Equal | Less | Less_equal | Minimum | Maximum | Divide | Pow
  | Elementary _ | Div | Mod | Bitwise _ | Round | Floor | Ceiling | Truncate | Not | And | Or ->
      None

let on_float real operator a : Ir.atom option =
  match operator with
  | Negate -> Some (Float (-.a))
  | Absolute -> Some (Float (Float.abs a))
  | Signum -> Some (Float (if a > 0. then 1. else if a < 0. then -1. else a))
  | Elementary f -> Option.map constant (elementary_of_one real f a)
  | Round -> Some (Int (saturate (Float.round a)))
  | Floor -> Some (Int (saturate (Float.floor a)))
  | Ceiling -> Some (Int (saturate (Float.ceil a)))
  | Truncate -> Some (Int (saturate (Float.trunc a)))
  | Add | Subtract | Multiply | Equal | Less | Less_equal | Minimum | Maximum | Divide | Pow | Div
  | Mod | Bitwise _ | To_float | Not | And | Or ->
      None

let operation real operator (arguments : Ir.atom list) : Ir.atom option =
  match (operator, arguments) with
  | _, [ Int a; Int b ] -> on_ints operator a b
  | _, [ Float a; Float b ] -> on_floats real operator a b
  | _, [ Int a ] -> on_int real operator a
  | _, [ Float a ] -> on_float real operator a
  | Equal, [ Bool a; Bool b ] -> Some (Bool (Bool.equal a b))
  | Not, [ Bool a ] -> Some (Bool (not a))
  | And, [ Bool a; Bool b ] -> Some (Bool (a && b))
  | Or, [ Bool a; Bool b ] -> Some (Bool (a || b))
  | _ -> None
