(* Each test: a Core program built by hand, and its Flow as text. *)

open Basis
open Trees
open Core.Ir

let flow definitions =
  let sink = Diagnostic.sink () in
  let core = program definitions in
  Core.Lint.program core;
  match Specialize.Evaluate.program sink ~name:"test" ~entry:(main "main") core with
  | Some flow ->
      Flow.Lint.program flow;
      Format.asprintf "%a" Flow.Print.program flow
  | None ->
      String.concat "\n"
        (List.map
           (fun (d : Diagnostic.t) -> Printf.sprintf "%s: %s" d.code d.message)
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

let _ = (sf, fn, let_, nothing, just, is_just, from_just, derivative, maybe, a, b, c)

let () =
  let test name f = Alcotest.test_case name `Quick f in
  Alcotest.run "Specialize.Evaluate"
    [
      ("equations", [ test "equations feed back through a delay" feedback ]);
      ("calls", [ test "one node serves all the numbers" one_node_for_all_numbers ]);
    ]
