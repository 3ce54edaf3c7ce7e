(* Tests where definitions run (their levels), on hand-built programs. *)

open Trees

let check expected definitions =
  let pass sink p = ignore (Typing.Levels.program (Advice.Of_typing.into sink) p) in
  Alcotest.(check string) "messages" expected (messages pass definitions)

let x = local 1 "x"
let y = local 2 "y"
let z = local 3 "z"
let k = local 4 "k"
let f = local 5 "f"
let vx = var x float
let one = number 1

let static_parameters () =
  check ""
    [
      ( "f",
        lambda
          [ bound k float ]
          (proc (bound x float)
             [ binding (bound y float) (plus (var k float) one) ]
             (delay (var y float) vx)) );
    ]

let chain () =
  check
    "E0340: the initial value of `delay` must be static, but `z` is a signal []\n\
    \  `z` is a signal: it depends on `y` here\n\
    \  `y` is a signal: it depends on `x` here\n\
    \  `x` is a signal: it comes from the `proc`'s input here"
    [
      ( "f",
        proc (bound x float)
          [
            binding (bound z float) (plus one (var y float)); binding (bound y float) (plus one vx);
          ]
          (delay (var z float) vx) );
    ]

let recursive_equations () =
  check
    "E0340: the initial value of `delay` must be static, but `y` is a signal []\n\
    \  `y` is a signal: a signal function runs here"
    [
      ( "f",
        proc (any float)
          [ binding (bound y float) (delay (var y float) (var y float)) ]
          (var y float) );
    ]

let branches () =
  check "E0342: `delay` is run in a branch [its output depends on when it started]"
    [ ("f", proc (bound x float) [] (case vx [ (any float, plus one (delay one vx)) ])) ]

let local_functions () =
  check "E0343: `delay` is run in the function `f` [`k` has a value only here]\n  `k` is bound here"
    [
      ( "f",
        proc (bound x float)
          [
            binding
              (bound f (Typing.Ir.Function (float, float)))
              (lambda [ bound k float ] (delay one (plus vx (var k float))));
          ]
          vx );
    ]

let outside () =
  check "E0341: `delay` is run outside of a `proc` [only a `proc` can run a signal function]"
    [ ("f", lambda [ bound x float ] (delay one vx)) ]

let signal_function ty = Typing.Ir.Signal_function (ty, ty)

let bound_signal_function () =
  check
    "E0344: `f` is a signal function and must be static, but `x` is a signal []\n\
    \  `x` is a signal: it comes from the `proc`'s input here"
    [
      ( "f",
        proc (bound x float)
          [
            binding
              (bound f (signal_function float))
              (proc (bound k float) [] (plus (var k float) vx));
          ]
          (apply (var f (signal_function float)) vx) );
    ]

let captured_signal () =
  check ""
    [
      ("f", proc (bound x float) [] (tuple [ proc (bound k float) [] (plus (var k float) vx); one ]));
    ]

let recursive_let () =
  check
    "E0346: `y` is used in its own definition [only the equations of a `proc` may be recursive]\n\
    \  `y` is defined here"
    [
      ( "f",
        lambda
          [ bound x float ]
          (let_ [ binding (bound y float) (plus (var y float) vx) ] (var y float)) );
    ]

let levels_filled_in () =
  let equations =
    [
      binding (bound y float) (plus one one);
      binding (bound z float) (plus vx one);
      binding (bound f float) (plus (var k float) one);
    ]
  in
  let value = lambda [ bound k float ] (proc (bound x float) equations vx) in
  let sink = Basis.Diagnostic.sink () in
  let p = Typing.Levels.program (Advice.Of_typing.into sink) (program [ ("f", value) ]) in
  match (List.hd p.definitions).value.desc with
  | Lambda (_, { desc = Proc { equations; _ }; _ }) ->
      Alcotest.(check bool)
        "constant, signal, static" true
        (List.map (fun (b : Typing.Ir.binding) -> b.level) equations
        = [ Typing.Ir.Constant; Signal; Static ])
  | _ -> Alcotest.fail "the definition has another shape"

let deep_expressions () =
  let rec nest n e wrap = if n = 0 then e else nest (n - 1) (wrap e) wrap in
  check ""
    [
      ("sum", lambda [ bound x float ] (nest 10_000 vx (fun e -> plus e one)));
      ("runs", proc (bound y float) [] (nest 10_000 (var y float) (delay one)));
    ]

let () =
  let test name f = Alcotest.test_case name `Quick f in
  Alcotest.run "Typing.Levels"
    [
      ( "static",
        [
          test "parameters of a signal function may be initial values" static_parameters;
          test "a chain of equations is shown" chain;
          test "an instance makes a signal of what it defines" recursive_equations;
          test "a signal function that is bound must be static" bound_signal_function;
          test "an inner proc may capture a signal" captured_signal;
        ] );
      ( "instances",
        [
          test "not in branches" branches;
          test "not in local functions" local_functions;
          test "not outside of procs" outside;
        ] );
      ( "bindings",
        [
          test "a let may not be recursive" recursive_let;
          test "levels are filled in" levels_filled_in;
          test "ten thousand deep" deep_expressions;
        ] );
    ]
