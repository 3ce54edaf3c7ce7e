(* Tests Flow's passes: what each of them removes, and that none of them changes an output. *)

open Flow

let root (program : Ir.program) = program.nodes.(Array.length program.nodes - 1)

let build root =
  let p = Build.create () in
  ignore (Build.node p "main" root);
  Build.program p

let lines program =
  let text = Format.asprintf "%a" Print.program program in
  List.filter (( <> ) "") (List.map String.trim (String.split_on_char '\n' text))

let random name count property =
  let test =
    QCheck.Test.make ~count ~name
      (QCheck.make ~print:string_of_int QCheck.Gen.(int_bound 1_000_000_000))
      property
  in
  Alcotest.test_case name `Quick (fun () ->
      QCheck.Test.check_exn ~rand:(Random.State.make [| 7 |]) test)

let same_outputs expected found = List.for_all2 (List.for_all2 Evaluate.equal) expected found

let show outputs =
  String.concat "\n"
    (List.map (fun values -> String.concat " " (List.map Evaluate.show values)) outputs)

(* Runs a causal random program before and after [pass]. *)
let keeps_outputs pass evaluate seed =
  let rng = Random.State.make [| seed |] in
  let program = Random_program.program rng in
  QCheck.assume (Causality.is_causal program);
  Lint.program program;
  let instants = Random_program.instants rng program in
  let expected = Evaluate.by_demand program instants in
  let optimized = pass program in
  Lint.program optimized;
  Initialization.check optimized;
  let found = evaluate optimized instants in
  if same_outputs expected found then true
  else
    QCheck.Test.fail_reportf "%a@.became@.%a@.expected@.%s@.found@.%s" Print.program program
      Print.program optimized (show expected) (show found)

(* A pass that changes nothing must return the same value, which allocates no memory. *)
let stays pass seed =
  let rng = Random.State.make [| seed |] in
  let program = Random_program.program rng in
  QCheck.assume (Causality.is_causal program);
  let done_ = pass program in
  Array.for_all2
    (fun (node : Ir.node) (again : Ir.node) ->
      again == node || Option.is_some node.machine || node.transitions <> [])
    done_.Ir.nodes (pass done_).Ir.nodes

let random_tests =
  [
    random "simplify keeps every bit" 400 (keeps_outputs Simplify.program Evaluate.by_demand);
    random "boolean simplification keeps every bit" 400
      (keeps_outputs Boolean_simplification.program Evaluate.by_demand);
    random "common subexpressions keep every bit" 400
      (keeps_outputs Common_subexpressions.program Evaluate.by_demand);
    random "dead code keeps every bit" 400 (keeps_outputs Dead_code.program Evaluate.by_demand);
    random "constant propagation keeps every bit" 400
      (keeps_outputs Constant_propagation.program Evaluate.by_demand);
    random "inline keeps every bit and leaves a schedule" 400
      (keeps_outputs Inline.program Evaluate.by_schedule);
    random "hoisting keeps every bit" 400 (keeps_outputs Hoisting.program Evaluate.by_demand);
    random "dead code is dead at once" 400 (stays Dead_code.program);
    random "all together keep every bit, run by schedule" 1000
      (keeps_outputs (fun p -> Optimize.program p) Evaluate.by_schedule);
  ]

(* Compares the remaining nodes with the expected text, in the format of {!Print}. *)

let check expected program =
  Lint.program program;
  let is_of_node line = not (String.length line > 7 && String.sub line 0 7 = "program") in
  Alcotest.(check (list string)) "what is left" expected (List.filter is_of_node (lines program))

let zero = Ir.Float 0.

let float_identities () =
  check
    [ "signal function main (x : Float)"; "a : Float = x + 0.0"; "-> ( = a,  = x,  = x,  = x)" ]
    (Dead_code.program
    @@ Simplify.program
         (build (fun b ->
              let x = Build.input b "x" in
              let a = Build.let_ b "a" (Op (Add, [ x; zero ])) in
              let minus_zero = Build.op b Add [ x; Float (-0.) ] in
              let times_one = Build.op b Multiply [ x; Float 1. ] in
              let twice_negated = Build.op b Negate [ Build.op b Negate [ x ] ] in
              [ ("", a); ("", minus_zero); ("", times_one); ("", twice_negated) ])))

let elementary_functions () =
  check
    [ "signal function main ()"; "-> ( = 0.47942553860420301,  = 2.0)" ]
    (Simplify.program
       (build (fun b ->
            let s = Build.let_ b "s" (Op (Elementary Sin, [ Float 0.5 ])) in
            let r = Build.let_ b "r" (Op (Elementary Sqrt, [ Float 4. ])) in
            [ ("", s); ("", r) ])))

let names_of_copies () =
  check
    [ "signal function main (x : Float)"; "speed : Float = negate(x)"; "-> ( = speed)" ]
    (Simplify.program
       (build (fun b ->
            let x = Build.input b "x" in
            let t = Build.op b Negate [ x ] in
            [ ("", Build.let_ b "speed" (Copy t)) ])))

let negations_are_not_kept () =
  check
    [
      "signal function main (x : Bool)";
      "_1 : Bool = delay False x";
      "d : Bool = not(_1)";
      "-> ( = d)";
    ]
    (Dead_code.program
    @@ Simplify.program
         (build (fun n ->
              let ty : Ir.ty = Bool in
              let x = Build.input ~ty n "x" in
              let off = Build.let_ ~ty n "off" (Op (Not, [ x ])) in
              [ ("", Build.let_ ~ty n "d" (Delay { init = Bool true; next = off })) ])))

(* Whether one of two events occurs, written as nested cases. *)
let conditions_in_cases () =
  check
    [ "signal function main (a : Bool, b : Bool)"; "either : Bool = a || b"; "-> ( = either)" ]
    (Optimize.program
       (build (fun n ->
            let ty : Ir.ty = Bool in
            let a = Build.input ~ty n "a" and b = Build.input ~ty n "b" in
            let choice condition then_ else_ =
              Build.let_ ~ty n "" (If { condition; then_; else_ })
            in
            let both = choice a b (Bool false) in
            let only_a = choice a (Build.let_ ~ty n "" (Op (Not, [ b ]))) (Bool false) in
            let one = choice only_a a b in
            [
              ( "",
                Build.let_ ~ty n "either" (If { condition = both; then_ = Bool true; else_ = one })
              );
            ])))

(* Two conditions of which one makes the other irrelevant. *)
let conditions_anyhow () =
  check
    [ "signal function main (a : Bool, b : Bool)"; "-> ( = a)" ]
    (Optimize.program
       (build (fun n ->
            let ty : Ir.ty = Bool in
            let a = Build.input ~ty n "a" and b = Build.input ~ty n "b" in
            let choice condition then_ else_ =
              Build.let_ ~ty n "" (If { condition; then_; else_ })
            in
            let both = choice a b (Bool false) in
            let only_a = choice a (Build.let_ ~ty n "" (Op (Not, [ b ]))) (Bool false) in
            [ ("", Build.let_ ~ty n "either" (Op (Or, [ both; only_a ]))) ])))

let known_constructors () =
  let p = Build.create () in
  let ty : Ir.ty = Sum 0 in
  ignore
    (Build.node p "main" (fun b ->
         let c = Build.input ~ty:Bool b "c" in
         let x = Build.input b "x" in
         let just = Build.let_ ~ty b "" (Construct { constructor = 1; payload = [ x ] }) in
         let nothing = Build.let_ ~ty b "" (Construct { constructor = 0; payload = [] }) in
         let m = Build.let_ ~ty b "m" (If { condition = c; then_ = just; else_ = nothing }) in
         let is_just = Build.let_ ~ty:Bool b "" (Is_constructor (m, 1)) in
         let v = Build.let_ b "" (Payload { value = m; constructor = 1; leaf = 0 }) in
         [ ("", Build.let_ b "y" (If { condition = is_just; then_ = v; else_ = zero })) ]));
  check
    [
      "signal function main (c : Bool, x : Float)"; "y : Float = if c then x else 0.0"; "-> ( = y)";
    ]
    (Optimize.program (Build.program ~sums:[| Random_program.maybe |] p))

(* Two delays, each with its own sum. *)
let delays first second =
  let main b =
    let x = Build.input b "x" in
    let delay name init =
      let sum = Build.let_ b "" (Op (Add, [ x; Float 1. ])) in
      ("", Build.let_ b name (Ir.Delay { init = Float init; next = sum }))
    in
    let n = delay "n" first in
    [ n; delay "m" second ]
  in
  Common_subexpressions.program (build main)

let shared_delays () =
  check
    [
      "signal function main (x : Float)";
      "_1 : Float = x + 1.0";
      "n : Float = delay 0.0 _1";
      "-> ( = n,  = n)";
    ]
    (delays 0. 0.)

let different_delays () =
  Alcotest.(check int) "0 and -0 are two" 3 (List.length (root (delays 0. (-0.))).equations)

(* A node that is too large to be inlined. *)
let large_node ?(name = "large") p =
  Build.node p name (fun b ->
      let x = Build.input b "x" in
      let unused = Build.input b "unused" in
      let gain = Build.input b "gain" in
      let rec sines n a =
        if n = 0 then a
        else sines (n - 1) (Build.op b (Elementary Sin) [ Build.op b Multiply [ a; gain ] ])
      in
      [ ("", sines 10 x); ("unread", Build.op b Negate [ unused ]) ])

let shared_instances () =
  let p = Build.create () in
  let large = large_node p in
  ignore
    (Build.node p "main" (fun b ->
         let x = Build.input b "x" in
         let run name input =
           let y = Build.declare b name and unread = Build.declare b "" in
           Build.call b large [ input; input; Float 2. ] [ y; unread ];
           Ir.Signal y
         in
         let a = run "a" x in
         let b' = run "b" x in
         [ ("", a); ("", b') ]));
  let program = Optimize.program (Build.program p) in
  let large = program.nodes.(0) in
  Alcotest.(check int) "one instance" 1 (List.length (root program).instances);
  Alcotest.(check (list string))
    "the literal and what nobody reads are no inputs" [ "x" ]
    (List.map (fun (s : Ir.signal) -> s.name) large.inputs);
  Alcotest.(check int) "one output" 1 (List.length large.outputs)

let inlined_for_feedback () =
  let p = Build.create () in
  let large = large_node p in
  let filter =
    Build.node p "filter" (fun b ->
        let u = Build.input b "u" in
        let y = Build.declare b "y" and unread = Build.declare b "" in
        Build.call b large [ u; u; u ] [ y; unread ];
        let held = Build.let_ b "held" (Delay { init = zero; next = Signal y }) in
        let other = Build.declare b "z" and unread = Build.declare b "" in
        Build.call b large [ held; u; held ] [ other; unread ];
        [ ("", Signal other) ])
  in
  ignore
    (Build.node p "main" (fun b ->
         let x = Build.input b "x" in
         let u = Build.declare b "u" in
         let y = Build.run b filter [ Signal u ] "y" in
         Build.define b u (Op (Subtract, [ x; y ]));
         [ ("", y) ]));
  let program = Optimize.program (Build.program p) in
  Lint.program program;
  Alcotest.(check (list string))
    "filter is open, what it calls is not" [ "large"; "large_2" ]
    (List.map (fun (i : Ir.instance) -> i.name) (root program).instances);
  Alcotest.(check int) "a schedule" 4 (List.length (Schedule.of_node (root program)))

let inlined_names () =
  let p = Build.create () in
  let double =
    Build.node p "double" (fun b ->
        let x = Build.input b "x" in
        let y = Build.let_ b "y" (Ir.Op (Add, [ x; x ])) in
        [ ("", Build.op b (Elementary Sin) [ y ]) ])
  in
  ignore
    (Build.node p "main" (fun b ->
         let x = Build.input b "x" in
         let y = Build.run b double [ x ] "y" in
         [ ("", Build.run b double [ y ] "z") ]));
  check
    [
      "signal function main (x : Float)";
      "double.y : Float = x + x";
      "y : Float = sin(double.y)";
      "double_2.y : Float = y + y";
      "z : Float = sin(double_2.y)";
      "-> ( = z)";
    ]
    (Optimize.program (Build.program p))

(* A node that computes the cosine of its input [a] and keeps state, so that a call is not free. *)
let turned p name =
  Build.node p name (fun b ->
      let a = Build.input b "a" and x = Build.input b "x" in
      let c = Build.let_ b "c" (Ir.Op (Elementary Cos, [ a ])) in
      let sum = Build.let_ b "sum" (Integral x) in
      [ ("", Build.op b Multiply [ c; sum ]) ])

let hoisted_cosines () =
  let p = Build.create () in
  let one = turned p "one" in
  let other = turned p "other" in
  ignore
    (Build.node p "main" (fun b ->
         let a = Build.input b "a" and x = Build.input b "x" in
         let y = Build.run b one [ a; x ] "y" in
         [ ("", y); ("", Build.run b other [ a; y ] "z") ]));
  let program = Hoisting.program (Build.program p) in
  Lint.program program;
  check
    [
      "signal function one (a : Float, x : Float, c : Float)";
      "c_2 : Float = c";
      "sum : Float = integral x";
      "_1 : Float = c_2 * sum";
      "-> ( = _1)";
      "signal function other (a : Float, x : Float, c : Float)";
      "c_2 : Float = c";
      "sum : Float = integral x";
      "_1 : Float = c_2 * sum";
      "-> ( = _1)";
      "signal function main (a : Float, x : Float)";
      "c : Float = cos(a)";
      "(y : Float) = one as one(a, x, c)";
      "(z : Float) = other as other(a, y, c)";
      "-> ( = y,  = z)";
    ]
    program

let hoisted_only_to_share () =
  let p = Build.create () in
  let one = turned p "one" in
  ignore
    (Build.node p "main" (fun b ->
         let a = Build.input b "a" and x = Build.input b "x" in
         let y = Build.run b one [ a; x ] "y" in
         [ ("", y); ("", Build.run b one [ x; y ] "z") ]));
  let program = Build.program p in
  Alcotest.(check bool) "unchanged" true (Hoisting.program program == program)

let chain n =
  build (fun b ->
      let x = Build.input b "x" in
      let y = ref x in
      for i = 1 to n / 2 do
        let d = Build.let_ b (Printf.sprintf "d%d" i) (Ir.Delay { init = zero; next = !y }) in
        y := Build.let_ b (Printf.sprintf "y%d" i) (Op (Add, [ d; !y ]))
      done;
      [ ("", !y) ])

let large () =
  let program = Optimize.program (chain 100_000) in
  Alcotest.(check int) "equations" 100_000 (List.length (root program).equations)

let example_tests =
  let case name f = Alcotest.test_case name `Quick f in
  [
    case "simplify: only identities of every float" float_identities;
    case "simplify: elementary functions of constants" elementary_functions;
    case "simplify: a copy's name goes on" names_of_copies;
    case "simplify: of a negation what it negates is kept" negations_are_not_kept;
    case "simplify: known constructors need no tag" known_constructors;
    case "boolean simplification: one that is said by cases" conditions_in_cases;
    case "boolean simplification: one for which another one does not matter" conditions_anyhow;
    case "common subexpressions: equal delays of equal signals are one" shared_delays;
    case "common subexpressions: 0 and -0 are different" different_delays;
    case "common subexpressions and constants: instances, literals, unread outputs" shared_instances;
    case "inline: what feeds back through its delay is opened, no more" inlined_for_feedback;
    case "inline: names stay, and tell instances apart where they clash" inlined_names;
    case "hoisting: two nodes share a cosine that their caller computes" hoisted_cosines;
    case "hoisting: functions of different arguments stay where they are" hoisted_only_to_share;
    case "nodes of 100,000 equations" large;
  ]

let () =
  Alcotest.run "Flow.Optimize" [ ("examples", example_tests); ("random programs", random_tests) ]
