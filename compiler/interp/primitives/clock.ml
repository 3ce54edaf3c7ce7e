type instant = int64

let seconds real ns = Basis.Real.round real (Basis.Real.of_int64 real ns /. 1e9)
let first = 0L

(* Doubles of 2^52 or more have no fractional part. *)
let to_nearest_even x =
  if x >= 0x1p52 then x
  else
    let below = Float.floor x in
    let rest = x -. below in
    if rest < 0.5 then below
    else if rest > 0.5 then below +. 1.
    else if Float.rem below 2. = 0. then below
    else below +. 1.

let whole x = if x > 0. then Int64.of_float (Float.min 1e18 (to_nearest_even x)) else first

let after (precision : Basis.Real.t) seconds =
  match precision with
  | Double -> whole (seconds *. 1e9)
  | Single when seconds > 0. && seconds < 0x1p23 ->
      let below = Float.floor seconds in
      let fraction = Basis.Real.round Single ((seconds -. below) *. 1e9) in
      Int64.add (whole (below *. 1e9)) (whole fraction)
  | Single -> whole (seconds *. 1e9)

let later time instant =
  if Int64.compare time (Int64.sub Int64.max_int instant) > 0 then Int64.max_int
  else Int64.add time instant
