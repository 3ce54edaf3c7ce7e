(* Flow's passes: what each of them removes, and that none changes an output. *)

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

let is_causal program =
  let sink = Basis.Diagnostic.sink () in
  Causality.check sink program;
  not (Basis.Diagnostic.has_errors sink)

let same_outputs expected found =
  List.for_all2 (List.for_all2 Evaluate.equal) expected found

let show outputs =
  String.concat "\n"
    (List.map (fun values -> String.concat " " (List.map Evaluate.show values)) outputs)

(* Runs a causal random program before and after [pass]. *)
let keeps_outputs pass evaluate seed =
  let rng = Random.State.make [| seed |] in
  let program = Random_program.program rng in
  QCheck.assume (is_causal program);
  Lint.program program;
  let instants = Random_program.instants rng program in
  let expected = Evaluate.by_demand program instants in
  let optimized = pass program in
  Lint.program optimized;
  let found = evaluate optimized instants in
  if same_outputs expected found then true
  else
    QCheck.Test.fail_reportf "%a@.became@.%a@.expected@.%s@.found@.%s" Print.program program
      Print.program optimized (show expected) (show found)

let random_tests =
  [
    random "simplify keeps every bit" 2000 (keeps_outputs Simplify.program Evaluate.by_demand);
    random "share keeps every bit" 2000 (keeps_outputs Share.program Evaluate.by_demand);
    random "dead keeps every bit" 2000 (keeps_outputs Dead.program Evaluate.by_demand);
    random "specific keeps every bit" 2000 (keeps_outputs Specific.program Evaluate.by_demand);
    random "inline keeps every bit and leaves a schedule" 2000
      (keeps_outputs Inline.program Evaluate.by_schedule);
    random "all together keep every bit, run by schedule" 5000
      (keeps_outputs Optimize.program Evaluate.by_schedule);
  ]

let () = ignore (root, build, lines); Alcotest.run "Flow.Optimize" [ ("random programs", random_tests) ]
