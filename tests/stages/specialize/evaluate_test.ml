(* Each test specializes a hand-built Core program and compares the resulting Flow as text. *)

open Basis
open Trees
open Core.Ir

let flow definitions =
  let sink = Diagnostic.sink () in
  let core = program definitions in
  Core.Lint.program core;
  match
    Specialize.Of_core.program (Advice.Of_specialize.into sink) ~name:"test" ~entry:(main "main")
      core
  with
  | Some flow ->
      Flow.Lint.program flow;
      Format.asprintf "%a" Flow.Print.program flow
  | None ->
      String.concat "\n"
        (List.map
           (fun (d : Diagnostic.t) ->
             Printf.sprintf "%s: %s" d.code (Diagnostic.for_display d.message))
           (Diagnostic.all sink))

let check expected definitions =
  Alcotest.(check string) "flow" ("program test\n" ^ expected) (flow definitions)

let x = local 10 "x" float
let y = local 11 "y" float
let z = local 12 "z" float
let i = local 13 "i" float
let j = local 14 "j" float
let sf a b : ty = Signal_function (a, b)
let fn a b : ty = Function (a, b)

let feedback () =
  let body =
    proc "main" i
      [ run x (delay (number 0.5)) (var y); y := var x + var i ]
      (tuple [ var y; number 1. ])
  in
  check
    {|signal function main (i : Float)
  x : Float = delay 0.5 y
  y : Float = x + i
  -> (out.1 = y, out.2 = 1.0)
|}
    [ fst (define "main" body) ]

let one_node_for_all_numbers () =
  let definition, scheme = define "scale" (lambda [ x; y ] ((var x * var y) + var y)) in
  let scale e = apply (global scheme []) e in
  let body =
    proc "main" i
      [ z := scale [ number 2.; var i ]; j := scale [ number 3.; scale [ number 4.; var z ] ] ]
      (var j)
  in
  check
    {|function scale (x : Float, y : Float)
  _1 : Float = x * y
  _2 : Float = _1 + y
  -> (out = _2)
signal function main (i : Float)
  (z : Float) = scale as scale(2.0, i)
  (_1 : Float) = scale as scale_2(4.0, z)
  (j : Float) = scale as scale_3(3.0, _1)
  -> (out = j)
|}
    [ definition; fst (define "main" body) ]

(* Variables without a name have negative ids. *)
let functions_are_no_definitions () =
  let z = local 30 "z" float and unnamed = local (-1) "" float in
  let definition, definition' = define "twice" (lambda [ z ] (var z + var z)) in
  let function_ = lambda [ unnamed ] (var unnamed * var unnamed) in
  let body =
    proc "main" i
      [ x := apply (global definition' []) [ var i ]; y := apply function_ [ var i ] ]
      (tuple [ var x; var y ])
  in
  check
    {|function twice (z : Float)
  _1 : Float = z + z
  -> (out = _1)
function main_2 (_1 : Float)
  _2 : Float = _1 * _1
  -> (out = _2)
signal function main (i : Float)
  (x : Float) = twice as twice(i)
  (y : Float) = main_2 as main(i)
  -> (out.1 = x, out.2 = y)
|}
    [ definition; fst (define "main" body) ]

(* (>>>) f g = proc x -> g (f x), at a, b, c *)
let compose =
  let ta : ty = Variable a and tb : ty = Variable b and tc : ty = Variable c in
  let f = local 20 "f" (sf ta tb) and g = local 21 "g" (sf tb tc) in
  let x = local 22 "x" ta and y = local 23 "" tb and z = local 24 "" tc in
  define ~parameters:[ a; b; c ] ">>>"
    (lambda [ f; g ] (proc ">>>" x [ run y (var f) (var x); run z (var g) (var y) ] (var z)))

let ( >>> ) f g = apply (global (snd compose) [ float; float; float ]) [ f; g ]

let composition () =
  let body = delay (number 0.5) >>> derivative in
  check
    {|signal function >>> (x : Float)
  _1 : Float = delay 0.5 x
  _2 : Float = derivative _1
  -> (out = _2)
|}
    [ fst compose; fst (define "main" body) ]

let a_statics_hole () =
  let x0 = local 30 "x0" float in
  let twice, twice' = define "twice" (lambda [ x0 ] (delay (var x0) >>> delay (var x0))) in
  let body =
    proc "main" i
      [
        run x (apply (global twice' []) [ number 1. ]) (var i);
        run y (apply (global twice' []) [ number 2. ]) (var x);
      ]
      (var y)
  in
  check
    {|signal function >>> [f : Float, g : Float] (x : Float)
  _1 : Float = delay f x
  _2 : Float = delay g _1
  -> (out = _2)
signal function main (i : Float)
  (x : Float) = >>> as >>>[1.0, 1.0](i)
  (y : Float) = >>> as >>>_2[2.0, 2.0](x)
  -> (out = y)
|}
    [ fst compose; twice; fst (define "main" body) ]

let doubling_is_linear () =
  let rec levels n previous definitions =
    if n = 0 then (previous, definitions)
    else
      let definition, scheme = define (Printf.sprintf "f%d" n) (previous >>> previous) in
      levels Stdlib.(n - 1) (global scheme []) (definition :: definitions)
  in
  let start, scheme = define "start" (delay (number 0.5)) in
  let last, definitions = levels 40 (global scheme []) [ start ] in
  let main = fst (define "main" last) in
  let text = flow ((fst compose :: List.rev definitions) @ [ main ]) in
  let lines = List.length (String.split_on_char '\n' text) in
  Alcotest.(check bool) "forty doublings in a few hundred lines" true (lines < 300)

let long_compositions () =
  let rec levels n previous definitions =
    if n = 0 then (previous, definitions)
    else
      let number = delay (number (float_of_int n)) in
      let definition, scheme = define (Printf.sprintf "s%d" n) (previous >>> number) in
      levels Stdlib.(n - 1) (global scheme []) (definition :: definitions)
  in
  let last, definitions = levels 6_000 (delay (number 0.5)) [] in
  let main = fst (define "main" last) in
  let text = flow ((fst compose :: List.rev definitions) @ [ main ]) in
  let length = String.length text in
  Alcotest.(check bool) "a few lines for each" true (length > 600_000 && length < 1_200_000)

let functions_of_signals () =
  let set v = local v "set" (fn float float) in
  let adder, adder' = define "adder" (lambda [ x; y ] ((var x * var x) + var y)) in
  let f = set 31 in
  let roMake, roMake' =
    define "roMake" (lambda [ f ] (apply (var f) [ apply (var f) [ number 0. ] ]))
  in
  let h = local 32 "h" (fn float float) in
  let body =
    proc "main" i
      [
        z := apply (global roMake' []) [ var h ];
        h := apply (global adder' []) [ var j ];
        j := var i + number 1.;
      ]
      (var z)
  in
  check
    {|function adder (x : Float, y : Float)
  _1 : Float = x * x
  _2 : Float = _1 + y
  -> (out = _2)
function roMake (x : Float)
  (_1 : Float) = adder as adder(x, 0.0)
  (_2 : Float) = adder as adder_2(x, _1)
  -> (out = _2)
signal function main (i : Float)
  j : Float = i + 1.0
  (z : Float) = roMake as roMake(j)
  -> (out = z)
|}
    [ adder; roMake; fst (define "main" body) ]

let signal_functions_in_tuples () =
  let pair = local 33 "pair" (Tuple [ sf float float; float ]) in
  let body =
    proc "main" i
      [
        run x (component (var pair) 0) (component (var pair) 1);
        pair := tuple [ delay (number 1.); number 3. ];
      ]
      (var x + var i)
  in
  check
    {|signal function main (i : Float)
  x : Float = delay 1.0 3.0
  _1 : Float = x + i
  -> (out = _1)
|}
    [ fst (define "main" body) ]

let chosen_functions () =
  let h = local 34 "h" (fn float float) in
  let double = lambda [ x ] (var x + var x) and square = lambda [ y ] (var y * var y) in
  let body =
    proc "main" i
      [ h := if_ (binary Less (var i) (number 0.)) double square; z := apply (var h) [ var i ] ]
      (var z)
  in
  check
    {|function main_2 (x : Float)
  _1 : Float = x + x
  -> (out = _1)
function main_3 (y : Float)
  _1 : Float = y * y
  -> (out = _1)
signal function main (i : Float)
  _1 : Bool = i < 0.0
  z : Float = if _1 then _2 else _3
  (_2 : Float) = main_2 as main(i)
  (_3 : Float) = main_3 as main_2(i)
  -> (out = z)
|}
    [ fst (define "main" body) ]

let sums_are_leaves () =
  let m = local 35 "m" (maybe float) and n = local 36 "n" (maybe float) in
  let body =
    proc "main" i
      [
        m := if_ (binary Less (var i) (number 0.)) (nothing float) (just (var i));
        run n (delay (nothing float)) (var m);
      ]
      (tuple
         [ if_ (is_just (var n)) (from_just (var n)) (number 7.); binary Equal (var m) (var n) ])
  in
  check
    {|signal function main (i : Float)
  _1 : Bool = i < 0.0
  _2 : Maybe Float = Nothing()
  _3 : Maybe Float = Just(i)
  m : Maybe Float = if _1 then _2 else _3
  _4 : Maybe Float = Nothing()
  n : Maybe Float = delay _4 m
  _5 : Bool = n ? Just
  _6 : Float = n.Just.0
  _7 : Float = if _5 then _6 else 7.0
  _8 : Bool = m ? Nothing
  _9 : Bool = n ? Nothing
  _10 : Bool = n ? Just
  _11 : Float = m.Just.0
  _12 : Float = n.Just.0
  _13 : Bool = _11 == _12
  _14 : Bool = _10 && _13
  _15 : Bool = if _8 then _9 else _14
  -> (out.1 = _7, out.2 = _15)
|}
    [ fst (define "main" body) ]

let destructured_parameters () =
  let parameter id = local id "" (Tuple [ float; Tuple [ float; float ] ]) in
  let p = parameter 40 and input = parameter 46 in
  let q = local 41 "q" (Tuple [ float; float ]) in
  let add, add' =
    define "add"
      (lambda [ p ]
         (let_ x
            (component (var p) 0)
            (let_ q (component (var p) 1) (var x + (component (var q) 0 * component (var q) 1)))))
  in
  let body =
    proc "main" input
      [ y := component (var input) 0; z := apply (global add' []) [ var input ] ]
      (var y * var z)
  in
  check
    {|function add (x : Float, q.1 : Float, q.2 : Float)
  _1 : Float = q.1 * q.2
  _2 : Float = x + _1
  -> (out = _2)
signal function main (y : Float, _1 : Float, _2 : Float)
  y_2 : Float = y
  _3 : Float = y_2 * z
  (z : Float) = add as add(y, _1, _2)
  -> (out = _3)
|}
    [ add; fst (define "main" body) ]

let joins_are_evaluated_once () =
  let u = local 42 "" (Tuple []) and k = local 43 "" (fn (Tuple []) float) in
  let fail = apply (var k) [ tuple [] ] in
  let less n = binary Less (var i) (number n) in
  let body =
    proc "main" i
      [
        z :=
          let_ k
            (lambda [ u ] (var i * var i))
            (if_ (less 1.) (if_ (less 0.) (number 5.) fail) fail);
      ]
      (var z)
  in
  check
    {|signal function main (i : Float)
  _1 : Bool = i < 1.0
  _2 : Bool = i < 0.0
  _3 : Float = i * i
  _4 : Float = if _2 then 5.0 else _3
  z : Float = if _1 then _4 else _3
  -> (out = z)
|}
    [ fst (define "main" body) ]

(* {1 Rejected programs} *)

let rejected expected definitions = Alcotest.(check string) "message" expected (flow definitions)

let recursion () =
  let f, f' = define "f" (lambda [ x ] (var x)) in
  let g, g' = define "g" (lambda [ y ] (apply (global f' []) [ var y ])) in
  let calling = lambda [ x ] (apply (global g' []) [ var x ]) in
  let main = define "main" (proc "main" i [] (apply (global g' []) [ var i ])) in
  rejected "E0410: `f` calls itself through other definitions"
    [ { f with body = calling }; g; fst main ]

let stored_functions () =
  let h = local 45 "h" (fn float float) in
  let body =
    proc "main" i
      [ run h (delay (lambda [ x ] (var x))) (lambda [ y ] (var y)) ]
      (apply (var h) [ var i ])
  in
  rejected "E0412: a value of type `Float -> Float` cannot be stored in a `delay`"
    [ fst (define "main" body) ]

(* {1 Size} *)

let rec nest n e wrap = if n = 0 then e else nest Stdlib.(n - 1) (wrap e) wrap

let deep_expressions () =
  let deep wrap = nest 10_000 (var i) wrap in
  let chain =
    let binder n = local Stdlib.(1000 + n) "l" float in
    let rec lets n =
      if n = 10_000 then var (binder 10_000)
      else let_ (binder Stdlib.(n + 1)) (var (binder n) + number 1.) (lets Stdlib.(n + 1))
    in
    let_ (binder 0) (var i) (lets 0)
  in
  let body =
    proc "main" i []
      (tuple
         [
           deep (fun e -> e + number 1.);
           deep (fun e -> number 1. + e);
           deep (fun e -> if_ (binary Less (var i) (number 1.)) (number 2.) e);
           chain;
         ])
  in
  Alcotest.(check bool) "a result" true (String.length (flow [ fst (define "main" body) ]) > 10_000)

let deep_calls () =
  let rec chain n previous definitions =
    if n = 0 then (previous, List.rev definitions)
    else
      let x = local Stdlib.(100_000 + n) "x" float in
      let definition, scheme =
        define (Printf.sprintf "f%d" n) (lambda [ x ] (apply previous [ var x ] + number 1.))
      in
      chain Stdlib.(n - 1) (global scheme []) (definition :: definitions)
  in
  let first, scheme = define "f" (lambda [ x ] (var x + var x)) in
  let last, definitions = chain 10_000 (global scheme []) [ first ] in
  let body = proc "main" i [] (apply last [ var i ]) in
  let text = flow (definitions @ [ fst (define "main" body) ]) in
  Alcotest.(check bool) "a result" true (String.length text > 10_000)

let () =
  let test name f = Alcotest.test_case name `Quick f in
  Alcotest.run "Specialize.Of_core"
    [
      ( "equations",
        [
          test "equations feed back through a delay" feedback;
          test "a sum is one leaf" sums_are_leaves;
          test "parameters keep the names of their patterns" destructured_parameters;
          test "where branches meet again is evaluated once" joins_are_evaluated_once;
        ] );
      ( "calls",
        [
          test "one node serves all the numbers" one_node_for_all_numbers;
          test "a function and a definition have nodes of their own" functions_are_no_definitions;
          test "functions are composed from signals" functions_of_signals;
          test "an unknown condition chooses among results" chosen_functions;
        ] );
      ( "signal functions",
        [
          test "composition is run" composition;
          test "numbers captured are statics" a_statics_hole;
          test "doubling a composition is linear" doubling_is_linear;
          test "a long composition does not hand on all its numbers" long_compositions;
          test "signal functions live in tuples" signal_functions_in_tuples;
        ] );
      ( "rejected",
        [
          test "functions that call each other" recursion;
          test "a function in a delay" stored_functions;
        ] );
      ( "size",
        [
          test "expressions ten thousand deep are evaluated" deep_expressions;
          test "a chain of ten thousand calls" deep_calls;
        ] );
    ]
