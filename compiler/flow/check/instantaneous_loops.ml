open Basis

let map = Long_list.map

(* {1 Cycles} *)

let targets = map (fun (t : Ir.transition) -> t.target)

(* Searches a mode for the signal function whose event causes a transition. Skips signals that
   satisfy [cannot_be_true]. *)
let source ?(cannot_be_true = fun _ -> false) (program : Ir.program) (node : Ir.node)
    (t : Ir.transition) =
  let definer = Hashtbl.create 32 in
  let define item (s : Ir.signal) = Hashtbl.replace definer s.id item in
  List.iter
    (fun (item : Schedule.item) ->
      match item with
      | Equation e -> define item e.defines
      | Instance i -> List.iter (define item) i.outputs
      | Trial _ | Machine _ -> ())
    (Schedule.in_source_order node);
  let seen = Hashtbl.create 32 in
  let rec search = function
    | [] -> None
    | (s : Ir.signal) :: others when Hashtbl.mem seen s.id || cannot_be_true s -> search others
    | s :: others -> (
        Hashtbl.replace seen s.id ();
        match Hashtbl.find_opt definer s.id with
        | None | Some (Schedule.Machine _ | Trial _) -> search others
        | Some (Equation e) -> search (others @ Operands.(signals (same_instant e.rhs)))
        | Some (Instance i) -> (
            match program.nodes.(i.node) with
            | { kind = Signal_function; origin; _ } -> Some (origin, i.span)
            | { kind = Function; _ } -> search (others @ Operands.signals i.inputs)))
  in
  search (Operands.signals [ t.occurs ])

(* The place of the cycle. If all its modes belong to the library, this is the place where the
   program uses them. *)
let place ~entry uses index (program : Ir.program) modes transitions first_mode =
  let span = program.nodes.(first_mode).span in
  let own = Own_code.is_own ~entry in
  let own_transition (t : Ir.transition) = if own t.span then Some t.span else None in
  if List.exists (fun mode -> own program.nodes.(mode).span) modes then span
  else
    match (List.find_map own_transition transitions, Own_code.use uses ~entry index) with
    | Some at, _ | None, Some (_, at) -> at
    | None, None -> entry

let report facts ~entry uses index (program : Ir.program) first (m : Ir.machine) ?limit hops =
  let modes = Array.of_list m.modes in
  let step ({ from; by } : Chains.hop) : Fact.step =
    let mode = modes.(from) in
    let cannot_be_true = First_transitions.cannot_be_true first mode in
    let source = source ~cannot_be_true program program.nodes.(mode) by in
    { mode; target = modes.(by.target); by; source }
  in
  let steps = map step hops in
  let modes = map (fun (step : Fact.step) -> step.mode) steps in
  let transitions = map (fun (step : Fact.step) -> step.by) steps in
  let at = place ~entry uses index program modes transitions (List.hd modes) in
  Facts.report facts (Fact.Endless { at; entry; program; steps; limit })

(* {1 Bounds} *)

let bound (program : Ir.program) (m : Ir.machine) chain =
  let entering (t : Ir.transition) = chain.(t.target) in
  let longest = List.fold_left (fun n t -> max n (entering t)) 0 in
  let running =
    List.fold_left (fun n index -> max n (1 + longest program.nodes.(index).transitions)) 1 m.modes
  in
  let running = max running (longest m.start) in
  let late, strict = List.partition (fun (t : Ir.transition) -> t.delayed) m.controls in
  max (running + longest late) (longest strict)

(* Marks the transitions that cannot occur in the first instant of their mode. *)
let mark (program : Ir.program) (nodes : Ir.node array) (m : Ir.machine) steps =
  List.iteri
    (fun k index ->
      let node = program.nodes.(index) in
      let transition (t : Ir.transition) =
        if List.memq t steps.(k) then t
        else { t with at_entry = Impossible (source program node t) }
      in
      nodes.(index) <- { (nodes.(index)) with transitions = map transition node.transitions })
    m.modes

(* The transitions along a cycle of modes. *)
let hops_of steps cycle =
  let hop from target : Chains.hop =
    { from; by = List.find (fun (t : Ir.transition) -> t.target = target) steps.(from) }
  in
  List.map2 hop cycle (List.tl cycle @ [ List.hd cycle ])

(* Analyses a version of the program in which small nodes are inlined, because that makes the
   analysis more precise. The result contains the corresponding transitions of the original
   program. *)
let chains (program : Ir.program) (expanded, first) index m : Chains.outcome =
  let expanded : Ir.program = Lazy.force expanded in
  let by_number (t : Ir.transition) mode =
    let rec find (ours : Ir.transition list) (theirs : Ir.transition list) =
      match (ours, theirs) with
      | ours :: _, theirs :: _ when theirs == t -> ours
      | _ :: ours, _ :: theirs -> find ours theirs
      | [], _ | _, [] ->
          Diagnostic.bug ~stage:"Flow.Instantaneous_loops"
            "a transition has no counterpart in the original program"
    in
    let node = List.nth m.Ir.modes mode in
    find program.nodes.(node).transitions expanded.nodes.(node).transitions
  in
  let expanded_machine = Option.get expanded.nodes.(index).machine in
  match Chains.of_machine (Lazy.force first) index expanded_machine with
  | Goes_far -> Goes_far
  | Goes_round hops ->
      Goes_round (List.map (fun (h : Chains.hop) -> { h with by = by_number h.by h.from }) hops)
  | Ends { steps; possible } ->
      let possible = Array.mapi (fun mode -> List.map (fun t -> by_number t mode)) possible in
      Ends { steps; possible }

let check_machine facts ~entry uses program first expanded nodes index (m : Ir.machine) =
  let steps = First_transitions.of_machine first m in
  let graph = Array.map targets steps in
  let components = Graph.components graph in
  let report = report facts ~entry uses index program first m in
  match List.find_opt (Graph.is_cyclic graph) components with
  | None ->
      mark program nodes m steps;
      { m with steps = bound program m (Chains.lengths graph components) }
  | Some component -> (
      match chains program expanded index m with
      | Ends { steps; possible } ->
          mark program nodes m possible;
          { m with steps }
      | Goes_round hops ->
          report hops;
          m
      | Goes_far ->
          report ~limit:Chains.most (hops_of steps (Graph.shortest_cycle graph component));
          m)

let program facts ~entry (program : Ir.program) =
  if Array.for_all (fun (node : Ir.node) -> Option.is_none node.machine) program.nodes then program
  else
    let first = First_transitions.of_program program in
    let uses = Own_code.uses program in
    (* If two closures have captured the same number, passes it as a single parameter. *)
    let to_look_at = lazy (Duplicate_parameters.program (Inline.to_look_at ~most:200 program)) in
    let expanded =
      (to_look_at, lazy (First_transitions.of_program ~patient:true (Lazy.force to_look_at)))
    in
    let nodes = Array.copy program.nodes in
    Array.iteri
      (fun index (node : Ir.node) ->
        let check = check_machine facts ~entry uses program first expanded nodes index in
        let machine = Option.map check node.machine in
        nodes.(index) <- { (nodes.(index)) with machine })
      program.nodes;
    { program with nodes }
