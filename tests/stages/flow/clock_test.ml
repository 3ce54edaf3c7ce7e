(* Tests local time in nanoseconds: values computed from the stored nanoseconds must equal, bit
   for bit, those computed from seconds. *)

open Flow

let of_seconds t = Clock.nanoseconds Double (Int64.to_float t /. 1e9)

(* The same bound as in [runtime/include/frob/step.h]: up to 2^51 the error of two roundings is
   less than half a nanosecond. *)
let exact_below = 0x4000000000000L

let exact () =
  let same t =
    if
      not
        (Int64.equal (Int64.bits_of_float (Int64.to_float t)) (Int64.bits_of_float (of_seconds t)))
    then Alcotest.failf "%Ld ns" t
  in
  let rng = Random.State.make [| 5 |] in
  for _ = 1 to 100_000 do
    same (Random.State.int64 rng exact_below);
    same (Int64.shift_right (Random.State.int64 rng exact_below) (Random.State.int rng 50));
    same (Int64.sub exact_below (Random.State.int64 rng 1000L))
  done

let reaches () =
  let check number =
    let reached t = of_seconds t >= number in
    match Clock.reaches Double number with
    | None -> if reached Int64.max_int then Alcotest.failf "%h is reached" number
    | Some least ->
        if not (reached least) then Alcotest.failf "%h is not reached at %Ld" number least;
        if least > 0L && reached (Int64.pred least) then
          Alcotest.failf "%h is reached before %Ld" number least
  in
  List.iter check
    [
      0.;
      -0.;
      -1.;
      0.5;
      1.;
      1e9;
      1e9 +. 0.5;
      4503599627370496.;
      9007199254740993.;
      9.2e18;
      1e19;
      Float.infinity;
      Float.neg_infinity;
      Float.nan;
    ];
  let rng = Random.State.make [| 6 |] in
  for _ = 1 to 10_000 do
    check (Float.of_int (Random.State.bits rng) *. Float.pow 2. (Random.State.float rng 35.));
    check (Float.of_int (Random.State.bits rng) *. 1000.)
  done

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "Flow.Clock"
    [
      ( "nanoseconds",
        [
          case "for thirteen days they are those that are kept" exact;
          case "the least time that reaches a number" reaches;
        ] );
    ]
