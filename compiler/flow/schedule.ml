open Basis

type item =
  | Equation of Ir.equation
  | Instance of Ir.instance
  | Trial of Ir.instance * Ir.trial
  | Machine of Ir.machine

(* Equations in their order; an instance before the first equation that is
   written after it. Only equations of the instance's own file can tell. *)
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
    | Instance i -> List.fold_right (fun trial items -> Trial (i, trial) :: items) i.trials (item :: items)
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

(* With what the start needs, which is static and so adds no cycles. *)
let needs_from_start item =
  match item with
  | Equation { rhs = Delay { init; _ }; _ } -> Operands.signals [ init ]
  | Machine m -> Operands.signals (Transitions.atoms m.start) @ needs item
  | Equation _ | Instance _ | Trial _ -> needs item

(* What no item defines is a parameter. *)
let definers items =
  let definer = Int_table.create (2 * Array.length items) in
  Array.iteri
    (fun v item -> List.iter (fun (s : Ir.signal) -> Int_table.replace definer s.id v) (defines item))
    items;
  definer

let graph ~needs items =
  let definer = definers items in
  Array.map
    (fun item -> List.filter_map (fun (s : Ir.signal) -> Int_table.find_opt definer s.id) (needs item))
    items

type progress = Not_reached | Waits_for_others | Placed

(* The items depth first, each after those that it needs; [None] if there is a cycle.
   Most nodes have none, and then this is the order of the graph's components, without
   the graph. *)
let without_cycles ~needs items =
  let definer = definers items in
  let progress = Array.make (Array.length items) Not_reached in
  let reach v =
    progress.(v) <- Waits_for_others;
    needs items.(v)
  in
  (* [waiting]: the items on the way to [v], each with the needs that are left of it. *)
  let rec place v (needed : Ir.signal list) waiting placed =
    match needed with
    | [] -> (
        progress.(v) <- Placed;
        let placed = items.(v) :: placed in
        match waiting with
        | (v, needed) :: waiting -> place v needed waiting placed
        | [] -> from (v + 1) placed)
    | s :: others -> (
        match Int_table.find_opt definer s.id with
        | None -> place v others waiting placed
        | Some w -> (
            match progress.(w) with
            | Placed -> place v others waiting placed
            | Waits_for_others -> None
            | Not_reached -> place w (reach w) ((v, others) :: waiting) placed))
  and from v placed =
    if v = Array.length items then Some (List.rev placed)
    else
      match progress.(v) with
      | Placed | Waits_for_others -> from (v + 1) placed
      | Not_reached -> place v (reach v) [] placed
  in
  from 0 []

let in_order items components =
  let append order component = List.fold_left (fun order v -> items.(v) :: order) order component in
  List.rev (List.fold_left append [] components)

let of_node (node : Ir.node) =
  match without_cycles ~needs (Array.of_list (in_source_order node)) with
  | Some items -> items
  | None -> Diagnostic.bug ~stage:"Flow.Schedule" "`%s` has a cycle" node.name

let as_far_as_possible node =
  let needs = needs_from_start in
  let items = Array.of_list (in_source_order node) in
  match without_cycles ~needs items with
  | Some items -> items
  | None -> in_order items (Graph.components (graph ~needs items))

let loops (node : Ir.node) =
  let items = Array.of_list (in_source_order node) in
  match without_cycles ~needs items with
  | Some _ -> []
  | None ->
      let graph = graph ~needs items in
      let instance v = match items.(v) with Instance i -> Some i | Equation _ | Trial _ | Machine _ -> None in
      List.filter_map
        (fun component ->
          if Graph.is_cyclic graph component then Some (List.filter_map instance component) else None)
        (Graph.components graph)
