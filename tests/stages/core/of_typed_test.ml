(* Each test translates a hand-built Typed program and compares the resulting Core as text. *)

open Trees

let dump definitions =
  let core = Core.Of_typed.program (program definitions) in
  Core.Lint.program core;
  Format.asprintf "%a" Core.Print.program core

let check expected definitions =
  Alcotest.(check string)
    "core"
    ("module Main\ndata Maybe a = Nothing | Just a\n\n" ^ expected)
    (dump definitions)

let x = local 1 "x"
let y = local 2 "y"
let m = local 3 "m"
let k = local 4 "k"

let anonymous_instances () =
  let body = plus (delay (number 0) (delay (number 1) (var x float))) (var y float) in
  check
    {|f :: SF (Float, Float) Float
f =
  proc f (_1 : (Float, Float)) where
    x : Float = _1.0
    y : Float = _1.1
    m : Float <- delay @Float 0 -< m
    _2 : Float <- delay @Float 1 -< x
    _3 : Float <- delay @Float 0 -< _2
    -> _3 + y
|}
    [
      ( "f",
        proc
          (pair (bound x float) (bound y float))
          [ binding (bound m float) (delay (number 0) (var m float)) ]
          body );
    ]

let instances_under_let () =
  let next = binding (bound k float) (plus (var x float) (number 1)) in
  check
    {|f :: SF Float Float
f =
  proc f (x : Float) where
    k : Float = x + 1
    _1 : Float <- delay @Float 0 -< k
    -> 1 + _1
|}
    [
      ( "f",
        proc (bound x float) [] (plus (number 1) (let_ [ next ] (delay (number 0) (var k float))))
      );
    ]

let fall_through () =
  let maybe_float = maybe_of float in
  let branches =
    [
      (construct just maybe_float [ bound x float ], guards [ (boolean false, var x float) ] None);
      (construct just maybe_float [ bound y float ], plus (var y float) (number 1));
      (any maybe_float, number 0);
    ]
  in
  check
    {|f :: Maybe Float -> Float
f =
  \(m : Maybe Float) ->
    let _1 : () -> Float =
      \(_2 : ()) -> if m ? Just
                    then let y : Float = m.Just.0 in
                         y + 1
                    else 0 in
    if m ? Just
    then let x : Float = m.Just.0 in
         if False then x else _1 ()
    else _1 ()
|}
    [ ("f", lambda [ bound m maybe_float ] (case (var m maybe_float) branches)) ]

let deep_expressions () =
  let rec nest n e wrap = if n = 0 then e else nest (n - 1) (wrap e) wrap in
  let text =
    dump
      [
        ("left", nest 10_000 (number 1) (fun e -> plus e (number 1)));
        ("right", nest 10_000 (number 1) (fun e -> plus (number 1) e));
        ("lets", nest 10_000 (number 1) (fun e -> let_ [ binding (any float) (number 1) ] e));
      ]
  in
  Alcotest.(check bool) "dumped" true (String.length text > 10_000)

let () =
  let test name f = Alcotest.test_case name `Quick f in
  Alcotest.run "Core.Of_typed"
    [
      ( "instances",
        [
          test "an instance in an operand becomes an equation" anonymous_instances;
          test "a let that an instance depends on becomes equations" instances_under_let;
        ] );
      ("patterns", [ test "guards fall through to the next branch" fall_through ]);
      ("size", [ test "expressions ten thousand deep are translated" deep_expressions ]);
    ]
