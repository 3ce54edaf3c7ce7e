module Stdlib_float = Float

(* [x ^ k] by squaring. The order of the multiplications is part of the language, because it
   determines how the result is rounded. *)
let rec power ~one ~times x k =
  if k = 0 then one
  else if k mod 2 = 0 then
    let half = power ~one ~times x (k / 2) in
    times half half
  else times x (power ~one ~times x (k - 1))

module Int = struct
  let absolute n = if Int32.compare n 0l < 0 then Int32.neg n else n
  let signum n = Int32.of_int (Int32.compare n 0l)

  (* OCaml's wider integers do not overflow; [Int32.of_int] wraps around. *)
  let wide f a b = Int32.of_int (f (Int32.to_int a) (Int32.to_int b))

  let div =
    wide (fun a b ->
        if b = 0 then 0
        else
          let quotient = a / b in
          if a mod b <> 0 && a < 0 <> (b < 0) then quotient - 1 else quotient)

  let modulo a b = if b = 0l then 0l else Int32.sub a (Int32.mul (div a b) b)

  let bitwise (operation : Core.Primitive.bitwise) =
    let shift a n = if n >= 0 then a lsl min n 32 else a asr min (-n) 32 in
    match operation with
    | Bit_and -> Int32.logand
    | Bit_or -> Int32.logor
    | Bit_xor -> Int32.logxor
    | Shift_left -> wide shift
    | Shift_right -> wide (fun a n -> shift a (-n))

  let power x k = power ~one:1l ~times:Int32.mul x k
end

module Float = struct
  let nan = Int64.float_of_bits 0x7ff8_0000_0000_0000L
  let signum x = if x > 0. then 1. else if x < 0. then -1. else x

  let extreme wins a b =
    if Stdlib_float.is_nan a || Stdlib_float.is_nan b then nan else if wins b a then b else a

  let minimum = extreme (fun b a -> b < a)
  let maximum = extreme (fun b a -> b > a)
  let add real a b = Basis.Real.round real (a +. b)
  let subtract real a b = Basis.Real.round real (a -. b)
  let multiply real a b = Basis.Real.round real (a *. b)
  let divide real a b = Basis.Real.round real (a /. b)

  let power real x k =
    let magnitude = power ~one:1. ~times:(multiply real) x (abs k) in
    if k < 0 then divide real 1. magnitude else magnitude

  let pow real x y =
    let module Elementary = (val Elementary.of_precision real) in
    Elementary.pow x y

  (* Rounds to an integer, ties to even. *)
  let nanoseconds real seconds =
    let ns = multiply real seconds 1e9 in
    let whole = Stdlib_float.floor ns in
    let rest = ns -. whole in
    if ns <= 0. then 0.
    else if rest > 0.5 || (rest = 0.5 && Stdlib_float.rem whole 2. = 1.) then whole +. 1.
    else whole

  let elementary (real : Basis.Real.t) (f : Core.Primitive.elementary) arguments =
    let module Elementary = (val Elementary.of_precision real) in
    match (f, arguments) with
    | Sqrt, [ x ] -> Basis.Real.round real (sqrt x)
    | Floor_float, [ x ] -> Stdlib_float.floor x
    | Ceiling_float, [ x ] -> Stdlib_float.ceil x
    | Nanoseconds, [ x ] -> nanoseconds real x
    | Hypot, [ x; y ] -> Elementary.hypot x y
    | Exp, [ x ] -> Elementary.exp x
    | Log, [ x ] -> Elementary.log x
    | Sin, [ x ] -> Elementary.sin x
    | Cos, [ x ] -> Elementary.cos x
    | Tan, [ x ] -> Elementary.tan x
    | Asin, [ x ] -> Elementary.asin x
    | Acos, [ x ] -> Elementary.acos x
    | Atan, [ x ] -> Elementary.atan x
    | Atan2, [ y; x ] -> Elementary.atan2 y x
    | ( ( Sqrt | Floor_float | Ceiling_float | Nanoseconds | Hypot | Exp | Log | Sin | Cos | Tan
        | Asin | Acos | Atan | Atan2 ),
        _ ) ->
        Basis.Diagnostic.bug ~stage:"Interp" "an elementary function of %d arguments"
          (List.length arguments)
end

let whole rounded x =
  let n = rounded x in
  if Stdlib_float.is_nan n then 0l
  else if n <= -2147483648. then Int32.min_int
  else if n >= 2147483647. then Int32.max_int
  else Int32.of_float n

let round = whole Stdlib_float.round
let floor = whole Stdlib_float.floor
let ceiling = whole Stdlib_float.ceil
let truncate = whole Stdlib_float.trunc
