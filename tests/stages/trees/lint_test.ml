(* Checks that each lint accepts the trees of a valid program and rejects each broken one. *)

open Basis

let text =
  {|half :: Float -> Float
half x = x / 2

main :: SF Float Float
main = switch (proc x -> (before + half x, edge (before > 3)) where before = delay 1 x)
    (\_ -> proc x -> half x)
|}

let the = Option.get
let library = "../../../stdlib"
let sink = Diagnostic.sink ()
let parsed = the (Syntax.Parse.program (Advice.Of_syntax.into sink) ~file:"main.frob" text)

let resolved =
  let on_disk = Resolve.Files.on_disk in
  let read path = if String.equal path "main.frob" then Ok text else on_disk.read path in
  the
    (Resolve.Program.load (Advice.Of_resolve.into sink) ~files:{ on_disk with read }
       ~remember:(fun ~file:_ _ -> ())
       ~library "main.frob")

let typed =
  Typing.Levels.program (Basis.Facts.ignored ())
    (Typing.Infer.program (Basis.Facts.ignored ()) ~real:Double resolved)

let core = Core.Of_typed.program typed
let main : Core.Ir.Global.t = { module_ = core.main_module; name = "main" }

let flow =
  Flow.Instantaneous_loops.program (Basis.Facts.ignored ()) ~entry:(Span.start_of_file "main.frob")
    (the
       (Specialize.Of_core.program (Advice.Of_specialize.into sink) ~name:"main" ~entry:main core))

let step = Step.Passes.program (Step.Of_flow.program (Flow.Optimize.program flow))
let is_half (name : Core.Ir.Global.t) = name.module_ = main.module_ && name.name = "half"

let finds ~stage lint good broken () =
  lint good;
  match lint broken with
  | () -> Alcotest.fail "nothing is found"
  | exception Diagnostic.Bug bug -> Alcotest.(check string) "who finds it" stage bug.stage

(* {1 Syntax} *)

let tuple_of_one : Syntax.Ir.program =
  let body : Syntax.Ir.body -> Syntax.Ir.body = function
    | Plain e -> Plain { e with desc = Tuple [ e ] }
    | guarded -> guarded
  in
  let declaration (d : Syntax.Ir.declaration) =
    match d.desc with
    | Binding b ->
        { d with desc = Binding { b with right = { b.right with body = body b.right.body } } }
    | _ -> d
  in
  { parsed with declarations = List.map declaration parsed.declarations }

let elsewhere : Syntax.Ir.program =
  let declaration (d : Syntax.Ir.declaration) =
    { d with span = { d.span with stop = d.span.start } }
  in
  { parsed with declarations = List.map declaration parsed.declarations }

(* {1 Names and types} *)

let of_half (g : Resolve.Ir.binding_group) =
  let defines (b : Resolve.Ir.binding) =
    match b.name with Top (name, _) -> is_half name | Inner _ | Destructure _ -> false
  in
  List.exists defines g.bindings

let without_half = { resolved with groups = List.filter (fun g -> not (of_half g)) resolved.groups }
let half_twice = { resolved with groups = List.filter of_half resolved.groups @ resolved.groups }

let typed_without_half =
  let stays (d : Typing.Ir.definition) = not (is_half d.name) in
  { typed with definitions = List.filter stays typed.definitions }

let half_of_another_type =
  let definition (d : Typing.Ir.definition) =
    if is_half d.name then { d with scheme = { d.scheme with ty = Bool } } else d
  in
  { typed with definitions = List.map definition typed.definitions }

let core_without_half =
  let stays (d : Core.Ir.definition) = not (is_half d.name) in
  { core with definitions = List.filter stays core.definitions }

let core_half_of_another_type =
  let definition (d : Core.Ir.definition) = if is_half d.name then { d with ty = Bool } else d in
  { core with definitions = List.map definition core.definitions }

(* {1 Equations} *)

let in_nodes change = { flow with nodes = Array.map change flow.nodes }
let without_equations = in_nodes (fun node -> { node with equations = [] })

let equations_twice =
  in_nodes (fun node -> { node with equations = node.equations @ node.equations })

let without_inputs =
  let instance (i : Flow.Ir.instance) = { i with inputs = [] } in
  in_nodes (fun node -> { node with instances = List.map instance node.instances })

let next_id_is_taken = { flow with next_id = Flow.Signals.next_id flow.nodes - 1 }

let starts_with_a_signal =
  let equation (e : Flow.Ir.equation) =
    match e.rhs with
    | Delay { init = _; next } -> { e with rhs = Delay { init = next; next } }
    | _ -> e
  in
  in_nodes (fun node -> { node with equations = List.map equation node.equations })

(* {1 Statements} *)

let with_step change =
  let node (n : Step.Ir.node) = { n with step = { n.step with body = change n.step.body } } in
  { step with nodes = Array.map node step.nodes }

let without_reset =
  let node (n : Step.Ir.node) = { n with reset = { n.reset with body = [] } } in
  { step with nodes = Array.map node step.nodes }

let () =
  let test name stage lint good broken =
    Alcotest.test_case name `Quick (finds ~stage lint good broken)
  in
  let syntax name = test name "Syntax" Syntax.Lint.program parsed in
  let resolve name = test name "Resolve.Lint" Resolve.Lint.program resolved in
  let typing name = test name "Typing.Lint" Typing.Lint.program typed in
  let core_ name = test name "Core.Lint" Core.Lint.program core in
  let flow_ name = test name "Flow.Lint" Flow.Lint.program flow in
  let start name = test name "Flow.Initialization" Flow.Initialization.check flow in
  let step_ name = test name "Step.Lint" Step.Lint.program step in
  Alcotest.run "Lints"
    [
      ("Syntax", [ syntax "a tuple of one" tuple_of_one; syntax "spans do not nest" elsewhere ]);
      ( "Resolve",
        [
          resolve "a name without a definition" without_half;
          resolve "a definition twice" half_twice;
        ] );
      ( "Typing",
        [
          typing "a name without a definition" typed_without_half;
          typing "a definition of another type" half_of_another_type;
        ] );
      ( "Core",
        [
          core_ "a name without a definition" core_without_half;
          core_ "a definition of another type" core_half_of_another_type;
        ] );
      ( "Flow",
        [
          flow_ "signals without an equation" without_equations;
          flow_ "signals with two equations" equations_twice;
          flow_ "instances without inputs" without_inputs;
          flow_ "a next id that is taken" next_id_is_taken;
          start "a delay that starts with a signal" starts_with_a_signal;
        ] );
      ( "Step",
        [
          step_ "a step that gives nothing" (with_step (fun _ -> []));
          step_ "a step that declares twice" (with_step (fun body -> body @ body));
          step_ "a reset that leaves the state" without_reset;
        ] );
    ]
