type axis = { name : string; unit_ : string; along : along }

and along =
  | Between of { low : float; high : float; steps : int; whole : bool }
  | Each of string list

(* SplitMix64 (Steele, Lea and Flood, 2014), which yields the same numbers on every machine. *)
let next state =
  state := Int64.add !state 0x9E3779B97F4A7C15L;
  let mix z shift factor = Int64.mul (Int64.logxor z (Int64.shift_right_logical z shift)) factor in
  let z = mix (mix !state 30 0xBF58476D1CE4E5B9L) 27 0x94D049BB133111EBL in
  Int64.logxor z (Int64.shift_right_logical z 31)

(* A number in the interval [0, 1). *)
let draw state = Int64.to_float (Int64.shift_right_logical (next state) 11) *. (2. ** -53.)
let below state count = int_of_float (draw state *. float_of_int count)

let text ~whole x =
  if whole then Printf.sprintf "%.0f" x else Basis.Real.shortest Basis.Real.Double x

(* The value at this fraction of the range. *)
let at axis share =
  match axis.along with
  | Between { low; high; whole; _ } when whole ->
      let count = high -. low +. 1. in
      text ~whole (low +. Float.min (Float.floor (share *. count)) (count -. 1.))
  | Between { low; high; whole; _ } -> text ~whole (low +. (share *. (high -. low)))
  | Each values ->
      let count = List.length values in
      List.nth values (min (count - 1) (int_of_float (share *. float_of_int count)))

let steps axis =
  match axis.along with
  | Each values -> values
  | Between { low; high; steps; whole } ->
      let step k =
        let share = float_of_int k /. float_of_int (steps - 1) in
        let x = low +. (share *. (high -. low)) in
        if k = 0 then low
        else if k = steps - 1 then high
        else if whole then Float.round x
        else float_of_string (Printf.sprintf "%.12g" x)
      in
      List.map (text ~whole) (List.sort_uniq compare (List.init steps step))

let count ~sampling ~points axes =
  let most = 1_000_000_000 in
  let along axis =
    match axis.along with Each values -> List.length values | Between { steps; _ } -> steps
  in
  match (sampling : Plan.sampling) with
  | Random | Latin -> points
  | Grid -> List.fold_left (fun product axis -> min most (product * along axis)) 1 axes

let rec grid = function
  | [] -> [ [] ]
  | axis :: others ->
      let rest = grid others in
      List.concat_map (fun value -> List.map (fun values -> value :: values) rest) (steps axis)

(* Fisher–Yates shuffle. *)
let shuffled state count =
  let order = Array.init count Fun.id in
  for k = count - 1 downto 1 do
    let other = below state (k + 1) in
    let kept = order.(k) in
    order.(k) <- order.(other);
    order.(other) <- kept
  done;
  order

let all ~sampling ~points ~seed axes =
  let state = ref (Int64.of_int seed) in
  let random () = Array.of_list (List.map (fun axis -> at axis (draw state)) axes) in
  match (sampling : Plan.sampling) with
  | Grid -> List.map Array.of_list (grid axes)
  | Random -> List.init points (fun _ -> random ())
  | Latin ->
      let column axis =
        let order = shuffled state points in
        Array.map
          (fun part -> at axis ((float_of_int part +. draw state) /. float_of_int points))
          order
      in
      let columns = List.map column axes in
      List.init points (fun k -> Array.of_list (List.map (fun column -> column.(k)) columns))
