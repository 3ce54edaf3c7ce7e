open Choice

type kind = Tame | Wild

let extreme_floats =
  [
    Interp.Number.Float.nan; Float.infinity; Float.neg_infinity; 0.; -0.; 1e308; -1e308; 5e-324; -2.3e-308;
    2147483647.5; -2147483648.5; 3.4028234663852886e38; 1e-45; 1e-39; 8388609.; 16777217.; 0.49999999999999994; 4503599627370497.5; 1e-9;
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
  | Float real -> Float (Basis.Real.round real (float random kind))
  | Tuple parts -> Tuple (Array.map known (Array.of_list parts))
  | Array (n, element) -> Array (Array.init n (fun _ -> known element))
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
