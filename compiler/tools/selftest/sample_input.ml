type row = { time_ns : int; cells : string list }

(* The columns of `Sample.frob`. *)
let header = "time,in.a,in.b,in.i,in.j,in.p,in.q,in.e,in.choice,in.xs[0],in.xs[1],in.xs[2],in.xs[3]"

(* A linear congruential generator with a multiplier from L'Ecuyer's tables (1999). OCaml's own
   generator may change, so we do not use it. Only the upper bits are sufficiently random. *)
type random = { mutable state : int }

let below random n =
  random.state <- (random.state * 2862933555777941757) + 3037000493;
  (random.state lsr 24) mod n

let pick random choices = List.nth choices (below random (List.length choices))
let number = Printf.sprintf "%.17g"

let edges (real : Basis.Real.t) =
  let largest, large =
    match real with
    | Double -> ("1.7976931348623157e308", "-1e300")
    | Single -> ("3.4028234663852886e38", "-1e30")
  in
  [
    "nan";
    "inf";
    "-inf";
    "0";
    "-0";
    "1";
    "-1";
    "5e-324";
    "2.2250738585072014e-308";
    largest;
    "2147483647.5";
    "-2147483648.5";
    "0.49999999999999994";
    "0.5";
    "-2.5";
    "4503599627370497.5";
    "1e-9";
    large;
  ]

let integer_edges = [ "0"; "1"; "-1"; "2"; "-2147483648"; "2147483647"; "7"; "-7" ]

let float real random ~tame =
  if (not tame) && below random 3 > 0 then pick random (edges real)
  else number (float_of_int (below random 8001 - 4000) /. 1000.)

let int random ~tame =
  if (not tame) && below random 3 > 0 then pick random integer_edges
  else string_of_int (below random 21 - 6)

let truth random = string_of_bool (below random 2 = 0)
let event real random ~tame = if below random 3 = 0 then float real random ~tame else ""

let choice random =
  match below random 3 with
  | 0 -> "Nothing"
  | 1 -> Printf.sprintf "Just %d" (below random 100)
  | _ -> Printf.sprintf "Just (-%d)" (1 + below random 100)

let tame_rows = 150
let all_rows = 200
let steps_ns = [ 20_000_000; 20_000_000; 50_000_000; 100_000_000; 0; 33_333_333; 1; 1_500_000_000 ]

let row real random number ~before =
  let tame = number < tame_rows in
  let time_ns = if number = 0 then 0 else before + pick random steps_ns in
  (* These definitions are separate because the order of evaluation determines the numbers. *)
  let a = float real random ~tame in
  let b = float real random ~tame in
  let i = int random ~tame in
  let j = int random ~tame in
  let p = truth random in
  let q = truth random in
  let e = event real random ~tame in
  let choice = choice random in
  let x0 = float real random ~tame in
  let x1 = float real random ~tame in
  let x2 = float real random ~tame in
  let x3 = float real random ~tame in
  { time_ns; cells = [ a; b; i; j; p; q; e; choice; x0; x1; x2; x3 ] }

let rows real =
  let random = { state = 20010807 } in
  let rec make number ~before =
    if number = all_rows then []
    else
      let row = row real random number ~before in
      row :: make (number + 1) ~before:row.time_ns
  in
  make 0 ~before:0

let csv rows =
  let line { time_ns; cells } =
    String.concat ","
      (Printf.sprintf "%d.%09d" (time_ns / 1_000_000_000) (time_ns mod 1_000_000_000) :: cells)
  in
  String.concat "\n" ((header :: List.map line rows) @ [ "" ])
