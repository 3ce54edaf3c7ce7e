(* Tests Flow.Schedule: an order of evaluation that follows the source where possible. *)

open Flow

let name_of = function
  | Schedule.Equation e -> e.defines.name
  | Schedule.Instance i -> i.name ^ "()"
  | Trial (i, _) -> i.name ^ "?"
  | Machine _ -> "machine"

let order (program : Ir.program) =
  let root = program.nodes.(Array.length program.nodes - 1) in
  List.map name_of (Schedule.of_node root)

let check expected program = Alcotest.(check (list string)) "order" expected (order program)

let build root =
  let p = Build.create () in
  let callee =
    Build.node p "double" (fun b ->
        let x = Build.input b "x" in
        [ ("", Build.let_ b "y" (Ir.Op (Add, [ x; x ]))) ])
  in
  ignore (Build.node p "main" (root callee));
  Build.program p

let operands_first () =
  check [ "c"; "b"; "a"; "d" ]
    (build (fun _ b ->
         let a = Build.declare b "a" and c1 = Build.declare b "b" and c2 = Build.declare b "c" in
         Build.define b a (Op (Negate, [ Signal c1 ]));
         Build.define b c1 (Op (Negate, [ Signal c2 ]));
         Build.define b c2 (Op (Negate, [ Float 1. ]));
         [ ("", Build.let_ b "d" (Op (Add, [ Signal a; Signal c2 ]))) ]))

let source_order_otherwise () =
  check [ "x"; "double()"; "y"; "z" ]
    (build (fun callee b ->
         let x = Build.let_ b "x" (Op (Negate, [ Float 1. ])) in
         let v = Build.run b callee [ x ] "v" in
         let y = Build.let_ b "y" (Op (Negate, [ Float 2. ])) in
         [ ("", Build.let_ b "z" (Op (Add, [ v; y ]))) ]))

let instances_wait_for_inputs () =
  check [ "late"; "double()"; "sum" ]
    (build (fun callee b ->
         let late = Build.declare ~line:90 b "late" in
         let v = Build.run b callee [ Signal late ] "v" in
         let sum = Build.let_ b "sum" (Op (Add, [ v; v ])) in
         Build.define b late (Op (Negate, [ Float 1. ]));
         [ ("", sum) ]))

let delays_need_nothing () =
  check [ "before"; "now" ]
    (build (fun _ b ->
         let now = Build.declare b "now" in
         let before = Build.let_ b "before" (Delay { init = Float 0.; next = Signal now }) in
         Build.define b now (Op (Add, [ before; Float 1. ]));
         [ ("", Signal now) ]))

let loops_name_their_instances () =
  let program =
    build (fun callee b ->
        let now = Build.declare b "now" in
        let next = Build.run b callee [ Signal now ] "next" in
        let other = Build.run b callee [ next ] "other" in
        Build.define b now (Op (Add, [ next; Float 1. ]));
        [ ("", other) ])
  in
  let root = program.nodes.(1) in
  Alcotest.(check (list (list string)))
    "instances" [ [ "double" ] ]
    (List.map (List.map (fun (i : Ir.instance) -> i.name)) (Schedule.loops root));
  match Schedule.of_node root with
  | _ -> Alcotest.fail "a cycle has no order"
  | exception Basis.Diagnostic.Bug _ -> ()

let large () =
  let program =
    build (fun _ b ->
        let n = 100_000 in
        let signals = Array.init n (fun i -> Build.declare b (string_of_int i)) in
        Array.iteri
          (fun i s ->
            let read = if i + 1 < n then Ir.Signal signals.(i + 1) else Ir.Float 0. in
            Build.define b s (Op (Negate, [ read ])))
          signals;
        [ ("", Signal signals.(0)) ])
  in
  Alcotest.(check (list string))
    "from the last to the first"
    (List.init 100_000 (fun i -> string_of_int (99_999 - i)))
    (order program)

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "Flow.Schedule"
    [
      ( "schedule",
        [
          case "operands come first" operands_first;
          case "the order is the source's where it can be" source_order_otherwise;
          case "an instance waits for its inputs" instances_wait_for_inputs;
          case "a delay needs nothing of the same instant" delays_need_nothing;
          case "loops name the instances that cannot run as one call" loops_name_their_instances;
          case "nodes of 100,000 equations" large;
        ] );
    ]
