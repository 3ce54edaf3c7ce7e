open Basis

type t = {
  program : Step.Ir.program;
  state : State.t;
  operations : Operations.t;
  stack : Stack.bounds;
  machines : Hops.machine list;
}

let of_program program =
  let state = State.of_program program in
  {
    program;
    state;
    operations = Operations.of_program program;
    stack = Stack.of_program program state;
    machines = Hops.of_program program;
  }

let place ~file (span : Span.t) =
  Printf.sprintf "%s:%d" (Filename.basename file) (Span.line span.start)

let operations : (string * Cost.kind) list =
  [
    ("additions", Additions);
    ("multiplications", Multiplications);
    ("divisions", Divisions);
    ("comparisons and choices", Choices);
    ("conversions", Conversions);
    ("loads of state", Loads);
    ("stores of state", Stores);
  ]

let library t = List.map fst (Cost.calls (Cost.larger t.operations.reset t.operations.step))
