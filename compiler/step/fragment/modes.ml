open Basis
module F = Flow.Ir

type context = {
  program : F.program;
  callee : int -> Ir.node;
  kept : State.machine;
  resolve : F.atom -> F.atom;
}

let variable (s : F.signal) : Ir.variable = { id = s.id; name = s.name; ty = Layout.ty s.ty }
let map = Basis.Long_list.map

let results_for_transitions (node : F.node) =
  let seen = Int_table.create 8 in
  let is_new (s : F.signal) =
    (not (Int_table.mem seen s.id))
    &&
    (Int_table.replace seen s.id ();
     true)
  in
  List.filter is_new (Flow.Operands.signals (Flow.Transitions.atoms node.transitions))

let broken what = Basis.Diagnostic.bug ~stage:"Step.Modes" "%s" what

let given value (parameters : Ir.variable list) =
  List.map (fun (v : Ir.variable) -> value v.id) parameters

(* The modes of a machine with their fields. *)
let targets context = Array.of_list context.kept.State.modes

(* [read] translates an argument to an expression. *)
let entry context targets read (t : F.transition) : Ir.entry =
  let mode : Ir.mode = targets.(t.target) in
  let index = mode.node in
  let values = Int_table.create 8 in
  List.iter2
    (fun (s : F.signal) a -> Int_table.replace values s.id a)
    context.program.nodes.(index).statics t.arguments;
  let value id =
    match Int_table.find_opt values id with
    | Some atom -> read atom
    | None -> broken "a mode starts with a value that is not a parameter"
  in
  {
    mode = t.target;
    parameters = List.map (fun ((v : Ir.variable), _) -> value v.id) mode.parameters;
    arguments =
      (match mode.state with
      | None -> []
      | Some _ -> given value (context.callee index).reset.parameters);
  }

(* The expression for a signal that a mode's step has returned as a result. *)
let read_result (atom : F.atom) : Ir.expr =
  match atom with
  | Signal s -> Variable (variable s)
  | Bool b -> Bool b
  | Int n -> Int n
  | Float x -> Float x

let case context targets ~inputs (mode : Ir.mode) : Ir.case =
  let node = context.program.nodes.(mode.node) in
  let values = Int_table.create 16 in
  List.iter2 (fun (s : F.signal) e -> Int_table.replace values s.id e) node.inputs inputs;
  List.iter
    (fun ((v : Ir.variable), field) -> Int_table.replace values v.id (Ir.Field field))
    mode.parameters;
  let value id =
    match Int_table.find_opt values id with
    | Some e -> e
    | None -> broken "a mode's step reads a value that it does not receive"
  in
  let next (t : F.transition) : Ir.next =
    {
      condition = read_result t.occurs;
      entry = entry context targets read_result t;
      delayed = t.delayed;
      at_entry = t.at_entry;
      span = t.span;
    }
  in
  {
    arguments = given value (context.callee mode.node).step.parameters;
    others = List.map variable (results_for_transitions node);
    transitions = List.map next node.transitions;
  }

(* Maps the operands of an action to their expressions. *)
let reader operands exprs =
  let signals = Int_table.create 16 in
  List.iter2
    (fun (atom : F.atom) e ->
      match atom with
      | Signal s -> Int_table.replace signals s.id e
      | Bool _ | Int _ | Float _ -> ())
    operands exprs;
  fun (atom : F.atom) ->
    match atom with
    | Signal s -> (
        match Int_table.find_opt signals s.id with
        | Some e -> e
        | None -> broken "an operand is missing")
    | Bool _ | Int _ | Float _ -> read_result atom

let step context (m : F.machine) =
  let m = Flow.Transitions.map_machine context.resolve Fun.id m in
  let operands = Flow.Transitions.read_in_step m in
  let late = List.exists (fun (t : F.transition) -> t.delayed) m.controls in
  let delayed mode =
    List.exists (fun (t : F.transition) -> t.delayed) context.program.nodes.(mode).transitions
  in
  let results = map variable m.outputs in
  let targets = targets context in
  let statements exprs =
    let read = reader operands exprs in
    let inputs = map read m.inputs in
    let run : Ir.run =
      {
        active = Option.map read m.active;
        clock = context.kept.clock;
        steps = m.steps;
        controls =
          List.map
            (fun (t : F.transition) -> (read t.occurs, entry context targets read t))
            m.controls;
        late;
        drops = late || List.exists delayed m.modes;
        cases = List.map (case context targets ~inputs) context.kept.modes;
        results;
        span = m.span;
      }
    in
    [ Ir.Run run ]
  in
  let weight =
    List.fold_left (fun sum mode -> sum + (context.callee mode).Ir.operations) 4 m.modes
  in
  Draft.work ~defines:m.outputs ~operands ~weight m.span statements

let start context (m : F.machine) =
  let transitions = Flow.Transitions.map context.resolve m.start in
  let operands = Flow.Transitions.atoms transitions in
  let targets = targets context in
  let statements exprs =
    let read = reader operands exprs in
    let rec choose : F.transition list -> Ir.statement list = function
      | [] -> broken "a machine without a first mode"
      | ({ occurs = Bool true; span; _ } as t) :: _ ->
          [ Enter { entry = entry context targets read t; span } ]
      | t :: others ->
          [
            If
              {
                uninitialized = [];
                condition = read t.occurs;
                then_ = [ Enter { entry = entry context targets read t; span = t.span } ];
                else_ = choose others;
                predicted = false;
                span = t.span;
              };
          ]
    in
    let clock =
      match context.kept.clock with
      | None -> []
      | Some { since; running; _ } ->
          [
            Ir.Assign { place = Own since; value = Zero_time; span = m.span };
            Assign { place = Own running; value = Bool false; span = m.span };
          ]
    in
    choose transitions @ clock
  in
  Draft.work ~operands m.span statements
