(* Tests Flow.Causality: which programs have a loop within one instant, and how it is reported. *)

open Basis
open Flow

let text (d : Diagnostic.t) =
  let shown = Diagnostic.for_display in
  let place (at : Span.t) = Printf.sprintf "%s:%d" at.file (Span.line at.start) in
  String.concat "\n"
    ([
       Printf.sprintf "%s %s: %s [%s]" (place d.at) d.code (shown d.message)
         (Option.fold d.here ~none:"" ~some:shown);
     ]
    @ List.map
        (fun (l : Diagnostic.label) -> Printf.sprintf "  %s: %s" (place l.at) (shown l.text))
        d.labels
    @ List.map (fun note -> "  note: " ^ shown note) d.notes
    @ List.map (fun (hint : Diagnostic.hint) -> "  hint: " ^ shown hint.text) d.hints)

let messages program =
  let sink = Diagnostic.sink () in
  Causality.check (Advice.Of_flow.into sink) ~entry:(Build.span "test.frob" 1) program;
  List.map text (Diagnostic.all sink)

let build root =
  let p = Build.create () in
  ignore (Build.node p "main" root);
  Build.program p

let check expected program = Alcotest.(check (list string)) "messages" expected (messages program)
let zero = Ir.Float 0.

let loop_of_two () =
  check
    [
      "test.frob:2 E0401: the signal `speed` needs its own value in the same instant [reads `err` \
       here]\n\
      \  test.frob:3: `err` reads `speed` here\n\
      \  hint: let `err` read the previous value of `speed`: add the equation `before = delay 0 \
       speed`, where 0 is the initial value, and read `before` here";
    ]
    (build (fun b ->
         let target = Build.input b "target" in
         let speed = Build.declare b "speed" in
         let err = Build.declare b "err" in
         Build.define b speed (Op (Multiply, [ Float 0.5; Signal err ]));
         Build.define b err (Op (Subtract, [ target; Signal speed ]));
         [ ("", Signal speed) ]))

let delay_breaks () =
  let feedback rhs =
    build (fun b ->
        let x = Build.input b "x" in
        let y = Build.declare b "y" in
        let z = Build.let_ b "z" (rhs (Ir.Signal y)) in
        Build.define b y (Op (Add, [ x; z ]));
        [ ("", Signal y) ])
  in
  check [] (feedback (fun y -> Ir.Delay { init = zero; next = y }));
  check [] (feedback (fun y -> Ir.Integral y));
  Alcotest.(check int)
    "derivative does not" 1
    (List.length (messages (feedback (fun y -> Ir.Derivative y))))

let both_branches_count () =
  let program ~loop_in_then =
    build (fun b ->
        let c = Build.input ~ty:Bool b "c" in
        let x = Build.declare b "x" in
        let then_, else_ = if loop_in_then then (Ir.Signal x, zero) else (zero, Ir.Signal x) in
        Build.define b x (If { condition = c; then_; else_ });
        [ ("", Signal x) ])
  in
  let expected =
    [
      "test.frob:2 E0401: the signal `x` needs its own value in the same instant [reads `x` here]\n\
      \  hint: let `x` read its own previous value: add the equation `before = delay 0 x`, where 0 \
       is the initial value, and read `before` here";
    ]
  in
  check expected (program ~loop_in_then:true);
  check expected (program ~loop_in_then:false)

let unnamed_are_skipped () =
  check
    [
      "test.frob:1 E0401: the signal `a` needs its own value in the same instant []\n\
      \  test.frob:7: `a` reads `b` here\n\
      \  test.frob:9: `b` reads `a` here\n\
      \  hint: let `b` read the previous value of `a`: add the equation `before = delay 0 a`, \
       where 0 is the initial value, and read `before` here";
    ]
    (build (fun b ->
         let a = Build.declare ~line:1 b "a" in
         let c = Build.declare ~line:4 b "b" in
         let left = Build.let_ ~line:7 b "" (Op (Negate, [ Signal c ])) in
         let left = Build.let_ ~line:6 b "" (Op (Add, [ left; Float 1. ])) in
         let right = Build.let_ ~line:9 b "" (Op (Negate, [ Signal a ])) in
         Build.define b a (Op (Multiply, [ left; Float 2. ]));
         Build.define b c (Copy right);
         [ ("", Signal a) ]))

(* u reaches the first output in the same instant; v reaches the second only after a delay. *)
let crossing p =
  Build.node p "crossing" (fun b ->
      let u = Build.input b "u" in
      let v = Build.input b "v" in
      let now = Build.let_ b "now" (Ir.Op (Add, [ u; Float 1. ])) in
      let before = Build.let_ b "before" (Ir.Delay { init = zero; next = v }) in
      [ ("1", now); ("2", before) ])

let leaf_by_leaf () =
  let program ~feed =
    let p = Build.create () in
    let callee = crossing p in
    ignore
      (Build.node p "main" (fun b ->
           let x = Build.input b "x" in
           let now = Build.declare b "now" in
           let before = Build.declare b "before" in
           let u, v =
             match feed with
             | `Delayed_input -> (x, Ir.Signal now)
             | `Delayed_output -> (Ir.Signal before, x)
             | `Same_instant -> (Ir.Signal now, x)
           in
           Build.call b callee [ u; v ] [ now; before ];
           [ ("", Signal now) ]));
    Build.program p
  in
  check [] (program ~feed:`Delayed_input);
  check [] (program ~feed:`Delayed_output);
  check
    [
      "test.frob:2 E0401: the signal `now` needs its own value in the same instant []\n\
      \  test.frob:4: `now` reads `now` here, through `crossing`\n\
      \  hint: let `now` read its own previous value: add the equation `before = delay 0 now`, \
       where 0 is the initial value, and read `before` here";
    ]
    (program ~feed:`Same_instant)

let groups_are_judged_as_one () =
  let program ~group =
    build (fun b ->
        let first = Build.declare b "p.1" in
        let group_of = if group then Some first else None in
        let second = Build.declare ?group_of b "p.2" in
        Build.define b first (Op (Add, [ Signal second; Float 1. ]));
        Build.define b second (Copy zero);
        [ ("", Signal first) ])
  in
  check [] (program ~group:false);
  check
    [
      "test.frob:1 E0401: the signal `p.1` needs its own value in the same instant [reads `p.2` \
       here]\n\
      \  hint: let `p.1` read the previous value of `p.1`, with `delay`";
    ]
    (program ~group:true)

let each_loop_is_reported () =
  let program =
    build (fun b ->
        let loop name =
          let x = Build.declare b name in
          Build.define b x (Op (Negate, [ Signal x ]));
          Ir.Signal x
        in
        let x = loop "x" in
        let y = loop "y" in
        let both = Build.op b Add [ x; y ] in
        [ ("", both) ])
  in
  Alcotest.(check int) "two loops" 2 (List.length (messages program))

let library_loop_shows_its_use () =
  let p = Build.create () in
  let loop =
    Build.node ~file:"Prelude.frob" p "loop" (fun b ->
        let c = Build.declare b "c" in
        Build.define b c (Op (Negate, [ Signal c ]));
        [ ("", Signal c) ])
  in
  let between =
    Build.node ~file:"Prelude.frob" p "between" (fun b -> [ ("", Build.run b loop [] "") ])
  in
  ignore (Build.node p "main" (fun b -> [ ("", Build.run b between [] "y") ]));
  check
    [
      "Prelude.frob:1 E0401: the signal `c` needs its own value in the same instant [reads `c` here]\n\
      \  test.frob:1: `between` runs here\n\
      \  hint: let `c` read its own previous value: add the equation `before = delay 0 c`, where 0 \
       is the initial value, and read `before` here";
    ]
    (Build.program p)

let library_loop_shows_what_it_closes () =
  let p = Build.create () in
  let own =
    Build.node p "step" (fun b ->
        let c = Build.input b "c" in
        [ ("", Build.op b Add [ c; Float 1. ]) ])
  in
  let loop =
    Build.node ~file:"Prelude.frob" p "loop" (fun b ->
        let z = Build.declare b "z" in
        Build.call ~line:1 b own [ Signal z ] [ z ];
        [ ("", Signal z) ])
  in
  ignore (Build.node p "main" (fun b -> [ ("", Build.run b loop [] "y") ]));
  check
    [
      "Prelude.frob:1 E0401: the signal `z` needs its own value in the same instant [reads `z` \
       here, through `step`]\n\
      \  test.frob:2: `step` passes `c` to this output in the same instant\n\
      \  test.frob:1: `loop` runs here\n\
      \  hint: let `step` read the previous value of `c`, with `delay`";
    ]
    (Build.program p)

let large ~closed =
  build (fun b ->
      let n = 100_000 in
      let signals = Array.init n (fun i -> Build.declare b (Printf.sprintf "x%d" i)) in
      Array.iteri
        (fun i s ->
          let read =
            if i > 0 then Ir.Signal signals.(i - 1)
            else if closed then Ir.Signal signals.(n - 1)
            else zero
          in
          Build.define b s (Op (Add, [ read; Float 1. ])))
        signals;
      [ ("", Signal signals.(n - 1)) ])

let large_nodes () =
  check [] (large ~closed:false);
  match messages (large ~closed:true) with
  | [ message ] ->
      Alcotest.(check int)
        "the loop is cut to what one can read" 14
        (List.length (String.split_on_char '\n' message))
  | _ -> Alcotest.fail "one message"

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "Flow.Causality"
    [
      ( "causality",
        [
          case "a loop of two signals shows both" loop_of_two;
          case "delay and integral break a loop, derivative does not" delay_breaks;
          case "both branches of an if count" both_branches_count;
          case "signals without names are skipped" unnamed_are_skipped;
          case "an instance is judged leaf by leaf" leaf_by_leaf;
          case "a group of leaves is judged as one" groups_are_judged_as_one;
          case "each loop is reported" each_loop_is_reported;
          case "a loop in the library shows where it is used" library_loop_shows_its_use;
          case "a loop in the library shows what it is closed around"
            library_loop_shows_what_it_closes;
          case "nodes of 100,000 equations" large_nodes;
        ] );
    ]
