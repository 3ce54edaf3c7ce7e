open Choice

type kind = Tame | Wild

let extreme_floats =
  [
    Interp.Number.Float.nan;
    Float.infinity;
    Float.neg_infinity;
    0.;
    -0.;
    1e308;
    -1e308;
    5e-324;
    -2.3e-308;
    2147483647.5;
    -2147483648.5;
    3.4028234663852886e38;
    1e-45;
    1e-39;
    8388609.;
    16777217.;
    0.49999999999999994;
    4503599627370497.5;
    1e-9;
  ]

let plain_floats = [ 0.; -0.; 1.; -1.; 0.5; -0.5; 1.5; 2.5; -2.5; 3.; 0.1 ]

let float random kind =
  match Random.State.int random 4 with
  | 0 when kind = Wild -> one_of random extreme_floats
  | 0 | 1 -> one_of random plain_floats
  | _ -> Random.State.float random 20. -. 10.

let extreme_ints = [ Int32.min_int; Int32.max_int; 65536l; -46341l; -2147483647l ]

let int random kind =
  if kind = Wild && chance random 3 then one_of random extreme_ints
  else Int32.of_int (Random.State.int random 21 - 10)

let rec value random kind (shape : Interp.Shape.t) : Interp.Value.t =
  let known shape = Interp.Thunk.known (value random kind shape) in
  match shape with
  | Bool -> Bool (Random.State.bool random)
  | Int -> Int (int random kind)
  | Text -> Text ""
  | Drawing -> Drawing []
  | Image -> Image (Frames.any random)
  | Float real -> Float (Basis.Real.round real (float random kind))
  | Tuple parts -> Tuple (Array.map known (Array.of_list parts))
  | Array (n, element) -> Array (Array.init n (fun _ -> known element))
  | Console controls ->
      let arguments = List.map (fun (_, shape, _) -> known shape) controls in
      Data { constructor = 0; arguments = Array.of_list arguments }
  | Data { constructors; _ } ->
      let constructor = Random.State.int random (List.length constructors) in
      let fields = (List.nth constructors constructor).fields in
      let arguments = Array.map (fun (_, shape) -> known shape) (Array.of_list fields) in
      Data { constructor; arguments }

let step_ns random =
  match Random.State.int random 8 with
  | 0 -> 0
  | 1 -> 1
  | 2 -> Random.State.int random 1000
  | 3 -> 1_000_000_000 * Random.State.int random 1000
  | _ -> Random.State.int random 200_000_000

let make random kind shape ~rows =
  let rec go n time found =
    if n = 0 then List.rev found
    else
      let value = value random kind shape in
      go (n - 1) (time + step_ns random) ((time, value) :: found)
  in
  Recording.make shape (go rows 0 [])

(* {1 Arbitrary dt} *)

let extreme_dts =
  [
    Float.nan;
    Float.infinity;
    Float.neg_infinity;
    0.;
    -0.;
    -1.;
    -1e-9;
    5e-324;
    1e-45;
    1e-30;
    4.9e-10;
    999999999.9999999;
    1e9;
    1000000001.;
    1e18;
    1e300;
    4503599.627370496;
    4503599.627370497;
    4194304.;
    4194303.9999999995;
    9.765625e-4;
    1.5e7;
    8388607.5;
  ]

(* A number of nanoseconds with a fraction of one half: below 2^52 for doubles, below 2^23 for
   singles. *)
let halves random =
  Float.of_int (Random.State.int random (1 lsl (1 + Random.State.int random 29))) +. 0.5

let dt random steady (precision : Basis.Real.t) =
  let beside x =
    let rec go n x =
      if n = 0 then x
      else go (n - 1) (if Random.State.bool random then Float.succ x else Float.pred x)
    in
    match precision with
    | Double -> go (Random.State.int random 4) x
    | Single -> x *. (1. +. (Float.of_int (Random.State.int random 7 - 3) *. 0x1p-24))
  in
  let seconds =
    match Random.State.int random 12 with
    | 0 -> one_of random extreme_dts
    | 1 -> halves random /. 1e9
    | 2 -> beside (Float.of_int (Random.State.int random 20_000_000) /. 1e9)
    | 3 -> Float.ldexp (1. +. Random.State.float random 1.) (Random.State.int random 70 - 40)
    | 4 | 5 -> Random.State.float random 0.2
    | 6 -> beside steady
    | _ -> steady
  in
  Basis.Real.round precision seconds

(* A dt of so few nanoseconds that in single precision one nanosecond, and mostly half of one,
   changes the time of a whole recording. *)
let fine_dt random precision =
  let ns = Float.of_int (Random.State.int random 4096) +. one_of random [ 0.; 0.25; 0.5; 0.5 ] in
  Basis.Real.round precision (ns /. 1e9)

let with_dt random precision shape ~rows =
  let steady = one_of random [ 0.02; 0.1; 1. /. 30.; 0.7; 0.05; 1. /. 3.; 0.008388609; 1e9 ] in
  let next_dt =
    match Random.State.int random 6 with
    | 0 | 1 -> fun () -> fine_dt random precision
    | 2 -> fun () -> if chance random 8 then dt random steady precision else 1e9
    | _ -> fun () -> dt random steady precision
  in
  let row _ =
    let dt = next_dt () in
    (dt, value random Tame shape)
  in
  Recording.with_dt precision shape (List.init rows row)
