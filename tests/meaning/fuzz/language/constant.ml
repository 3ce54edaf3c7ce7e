open Choice
open Scope

let f = Printf.sprintf

let floats =
  [
    "0.0";
    "(-0.0)";
    "1.0";
    "(-1.0)";
    "0.5";
    "(-0.5)";
    "1.5";
    "2.5";
    "(-2.5)";
    "3";
    "0.1";
    "100.0";
    "1.0e10";
    "(-1.0e-10)";
    "2147483648.0";
    "30[deg]";
    "pi";
  ]

let odd_floats =
  [ "(0.0 / 0.0)"; "(1.0 / 0.0)"; "((-1.0) / 0.0)"; "(-0.0)"; "1.0e300"; "(-1.0e300)"; "5.0e-324" ]

(* Replaces numbers that are out of range in single precision with numbers near the end of its
   range. *)
let in_range : Basis.Real.t -> string -> string = function
  | Double -> Fun.id
  | Single ->
      let replaced pattern text = Str.global_replace (Str.regexp_string pattern) text in
      fun program -> replaced "1.0e300" "3.0e38" (replaced "5.0e-324" "1.0e-45" program)

let ints =
  [
    "0";
    "1";
    "2";
    "(-1)";
    "(-3)";
    "7";
    "100";
    "65537";
    "0x7F";
    "0b1010";
    "0o17";
    "1_000";
    "2147483647";
    "(-2147483647 - 1)";
  ]

let measure s u =
  let unit = Type.unit_text u in
  let number number = f "%s[%s]" number unit in
  if chance s.random s.bias.odd_numbers then
    one_of s.random
      [ f "(0[%s] / 0.0)" unit; f "(1[%s] / 0.0)" unit; f "(-%s)" (number "0.0"); number "1.0e300" ]
  else
    let scaled =
      match u with
      | { metres = 1; seconds = 0 } -> [ "250[mm]"; "0.1[km]"; "3[cm]" ]
      | { metres = 0; seconds = 1 } -> [ "100[ms]"; "2[min]"; "1[us]" ]
      | { metres = 0; seconds = -1 } -> [ "5[Hz]"; "30[rpm]" ]
      | _ -> [ number "0.5" ]
    in
    one_of s.random
      ([ "0"; number "1"; number "2.5"; f "(-%s)" (number "0.1"); number "1.0e10" ] @ scaled)

let annotated text ty = f "(%s :: %s)" text (Type.text ty)

let construct (data : Type.data) (c : Type.constructor) arguments =
  if Type.is_record data then
    let field (name, _) argument = f "%s = %s" name argument in
    f "%s { %s }" c.name (String.concat ", " (List.map2 field c.fields arguments))
  else String.concat " " (c.name :: arguments)

let array elements = f "[%s]" (String.concat ", " elements)

let odd_float s =
  let text = one_of s.random odd_floats in
  if String.equal text "(0.0 / 0.0)" then note s "NaN";
  text

let rec literal s (ty : Type.t) =
  match ty with
  | Float -> if chance s.random s.bias.odd_numbers then odd_float s else one_of s.random floats
  | Measure u -> measure s u
  | Array (n, t) -> array (List.init n (fun _ -> literal s t))
  | Int -> one_of s.random ints
  | Bool -> one_of s.random [ "True"; "False" ]
  | Tuple parts -> f "(%s)" (String.concat ", " (List.map (literal s) parts))
  | Data data ->
      let c = one_of s.random data.constructors in
      annotated (construct data c (List.map (fun (_, t) -> literal s t) c.fields)) ty
