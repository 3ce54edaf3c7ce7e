open Basis

type item =
  | Equation of Ir.equation
  | Instance of Ir.instance
  | Trial of Ir.instance * Ir.trial
  | Machine of Ir.machine

(* Merges the equations, in their order, with the instances. Each instance comes before the first
   equation that is written after it. An instance is only compared with equations from the same
   file. *)
let in_source_order (node : Ir.node) =
  let precedes (instance : Ir.instance) (equation : Ir.equation) =
    String.equal instance.span.file equation.span.file
    && Span.compare instance.span equation.span <= 0
  in
  let rec merge items (instances : Ir.instance list) (equations : Ir.equation list) =
    match (instances, equations) with
    | [], [] -> List.rev items
    | i :: instances, [] -> merge (Instance i :: items) instances []
    | i :: instances, e :: _ when precedes i e -> merge (Instance i :: items) instances equations
    | _, e :: equations -> merge (Equation e :: items) instances equations
  in
  let with_trials item items =
    match item with
    | Instance i ->
        List.fold_right (fun trial items -> Trial (i, trial) :: items) i.trials (item :: items)
    | Equation _ | Trial _ | Machine _ -> item :: items
  in
  let items = merge [] node.instances node.equations in
  let has_trials (i : Ir.instance) = i.trials <> [] in
  let items =
    if List.exists has_trials node.instances then List.fold_right with_trials items [] else items
  in
  match node.machine with
  | None -> items
  | Some machine -> List.rev (Machine machine :: List.rev items)

let defines = function
  | Equation e -> [ e.defines ]
  | Instance { outputs; trials = []; _ } -> outputs
  | Instance { outputs; trials; _ } ->
      let is_given (s : Ir.signal) =
        List.exists
          (fun (t : Ir.trial) -> List.exists (fun (g : Ir.signal) -> g.id = s.id) t.gives)
          trials
      in
      List.filter (fun s -> not (is_given s)) outputs
  | Trial (_, trial) -> trial.gives
  | Machine m -> m.outputs

let needs = function
  | Equation e -> Operands.(signals (same_instant e.rhs))
  | Instance i ->
      let trials = List.concat_map (fun (t : Ir.trial) -> t.gives) i.trials in
      List.rev_append trials (Operands.signals (List.rev_append (List.rev i.statics) i.inputs))
  | Trial (i, trial) ->
      Operands.signals (List.rev_append (List.rev i.statics) (List.filter_map Fun.id trial.given))
  | Machine m -> Operands.signals (Transitions.read_in_step m)

(* Like [needs], but includes the signals needed at the start. They are static, so they add no
   cycles. *)
let needs_from_start item =
  match item with
  | Equation { rhs = Delay { init; _ }; _ } -> Operands.signals [ init ]
  | Machine m -> Operands.signals (Transitions.atoms m.start) @ needs item
  | Equation _ | Instance _ | Trial _ -> needs item

(* The dependency graph of the items. Signals that no item defines are parameters. *)
let graph ~needs items =
  let definer = Int_table.create (2 * Array.length items) in
  let define v (s : Ir.signal) = Int_table.replace definer s.id v in
  Array.iteri (fun v item -> List.iter (define v) (defines item)) items;
  let vertex (s : Ir.signal) = Int_table.find_opt definer s.id in
  Array.map (fun item -> List.filter_map vertex (needs item)) items

let in_order items components =
  let append order component = List.fold_left (fun order v -> items.(v) :: order) order component in
  List.rev (List.fold_left append [] components)

(* The items of a node, their dependency graph, and its components in evaluation order. *)
let components ~needs node =
  let items = Array.of_list (in_source_order node) in
  let graph = graph ~needs items in
  (items, graph, Graph.components graph)

let as_far_as_possible node =
  let items, _, components = components ~needs:needs_from_start node in
  in_order items components

let of_node (node : Ir.node) =
  let items, graph, components = components ~needs node in
  if List.exists (Graph.is_cyclic graph) components then
    Diagnostic.bug ~stage:"Flow.Schedule" "`%s` has a cycle" node.name;
  in_order items components

let loops (node : Ir.node) =
  let items, graph, components = components ~needs node in
  let instance v =
    match items.(v) with Instance i -> Some i | Equation _ | Trial _ | Machine _ -> None
  in
  List.filter_map
    (fun component ->
      if Graph.is_cyclic graph component then Some (List.filter_map instance component) else None)
    components
