(* Tests which values patterns cover, on hand-built cases. *)

open Trees

let check expected definitions =
  let checked sink program = Typing.Patterns.check (Advice.Of_typing.into sink) program in
  Alcotest.(check string) "messages" expected (messages checked definitions)

let m = local 1 "m"
let x = local 2 "x"
let y = local 3 "y"
let maybe_float = maybe_of float
let one = number 1
let just_ p = construct just maybe_float [ p ]
let nothing_ = construct nothing maybe_float []

let of_maybe branches =
  [ ("f", lambda [ bound m maybe_float ] (case (var m maybe_float) branches)) ]

let of_pair branches =
  let ty : Typing.Ir.ty = Tuple [ maybe_float; maybe_float ] in
  [ ("f", lambda [ bound m ty ] (case (var m ty) branches)) ]

let complete () = check "" (of_maybe [ (just_ (any float), one); (nothing_, one) ])

let missing_constructor () =
  check "E0350: this `case` does not cover every value [there is no branch for `Just _`]"
    (of_maybe [ (nothing_, one) ])

let missing_literal () =
  check "E0350: this `case` does not cover every value [there is no branch for `Just 1`]"
    (of_maybe [ (nothing_, one); (just_ (literal 0 float), one) ])

let nested () =
  check "E0350: this `case` does not cover every value [there is no branch for `(Nothing, Just _)`]"
    (of_pair [ (pair (just_ (any float)) (any maybe_float), one); (pair nothing_ nothing_, one) ])

let guards_cover_nothing () =
  check
    "E0350: this `case` does not cover every value [there is no branch for `Just _`]\n\
    \  all guards of this branch may fail"
    (of_maybe [ (nothing_, one); (just_ (bound x float), guards [ (boolean true, one) ] None) ])

let never_taken () =
  check "W0301: this branch is never taken [the branches before it cover all its values]"
    (of_maybe [ (nothing_, one); (bound y maybe_float, one); (just_ (any float), one) ])

let refutable_parameter () =
  check "E0351: the pattern of a function must match every value [does not match `Nothing`]"
    [ ("f", lambda [ just_ (bound x float) ] (var x float)) ]

let guards_outside_of_cases () =
  check "E0352: all these guards may fail [there is no value if they do]"
    [ ("f", lambda [ bound x float ] (guards [ (boolean true, var x float) ] None)) ]

let many_branches () =
  let branches = List.init 10_000 (fun n -> (just_ (literal n float), one)) in
  check "" (of_maybe (branches @ [ (any maybe_float, one) ]))

let () =
  let test name f = Alcotest.test_case name `Quick f in
  Alcotest.run "Typing.Patterns"
    [
      ( "cases",
        [
          test "a complete case says nothing" complete;
          test "a missing constructor is named" missing_constructor;
          test "a missing number is found" missing_literal;
          test "the missing value may be nested" nested;
          test "guards cover nothing" guards_cover_nothing;
          test "a branch that is never taken is a warning" never_taken;
          test "ten thousand branches are quick" many_branches;
        ] );
      ( "bindings",
        [
          test "a parameter must always match" refutable_parameter;
          test "guards without a last resort are for cases" guards_outside_of_cases;
        ] );
    ]
