type t = Syntax.Ir.rational

exception Out_of_range

let limit = 1_000_000
let rec gcd a b = if b = 0 then a else gcd b (a mod b)

let lowest_terms numerator denominator =
  let divisor = gcd (abs numerator) (abs denominator) in
  let divisor = if denominator < 0 then -divisor else divisor in
  (numerator / divisor, denominator / divisor)

let make numerator denominator : t =
  let numerator, denominator =
    if denominator = 1 then (numerator, denominator) else lowest_terms numerator denominator
  in
  if abs numerator > limit || denominator > limit then raise Out_of_range;
  { numerator; denominator }

let of_int n = make n 1
let zero = of_int 0
let one = of_int 1

let add (a : t) (b : t) =
  make
    ((a.numerator * b.denominator) + (b.numerator * a.denominator))
    (a.denominator * b.denominator)

let negate (a : t) : t = { a with numerator = -a.numerator }
let multiply (a : t) (b : t) = make (a.numerator * b.numerator) (a.denominator * b.denominator)
let inverse (a : t) = make a.denominator a.numerator
let is_zero (a : t) = a.numerator = 0
let is_negative (a : t) = a.numerator < 0
let is_integer (a : t) = a.denominator = 1
let equal (a : t) (b : t) = a.numerator = b.numerator && a.denominator = b.denominator

let to_string (a : t) =
  if is_integer a then string_of_int a.numerator
  else Printf.sprintf "%d/%d" a.numerator a.denominator
