open Basis

let map = Long_list.map

(* {1 Cycles} *)

let targets = map (fun (t : Ir.transition) -> t.target)

(* The signal function whose event causes a transition, searched within the mode. Skips signals that
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

(* A hint for the event's source. For time-outs of the library, the source is the prelude's [after]
   or [elapsed]. The user cannot change an event that occurs inside the library. *)
let hint ~entry ~(by : Ir.follower) sources =
  match (List.map fst sources, by) with
  | "after" :: _, _ -> "wait for at least 1 ns: `after (max 1[ms] q)`"
  | "elapsed" :: _, _ -> "wait for at least 1 ns: `max 1[ms] q`"
  | _ :: _, _ when not (List.exists (fun (_, at) -> Own_code.is_own ~entry at) sources) ->
      "add a task that takes time to the loop, such as `sleepT 10[ms] restingOutput`, where \
       `restingOutput` is the output of a robot at rest"
  | _, Statement _ ->
      "use `untilT (proc x -> (…, condition))`, which ends when the condition is true but takes at \
       least one instant; `edge` would wait forever if the condition were true from the start"
  | _, Continuation _ ->
      "apply `notYet` to the event to ignore it at the first instant; `edge` would wait forever if \
       the condition were true from the start"

(* The modes of the cycle, and the definitions that determine the next mode. *)
let circle hops =
  let names (from, target, (by : Ir.follower)) =
    match by with
    | (Continuation name | Statement name) when name <> from && name <> target -> [ from; name ]
    | Continuation _ | Statement _ -> [ from ]
  in
  Enumeration.circle (List.concat_map names hops)

(* A note about the instant in which the modes follow each other immediately. *)
let note modes =
  let at_which what =
    Printf.sprintf "no time passes between these steps at an instant at which %s" what
  in
  match List.sort_uniq compare modes with
  | [ (mode, Some event) ] when mode <> event ->
      at_which (Printf.sprintf "`%s` occurs as soon as `%s` starts" event mode)
  | [ (mode, _) ] -> at_which (Printf.sprintf "`%s` ends as soon as it starts" mode)
  | _ -> at_which "each ends as soon as it starts"

(* The place for the message. For a cycle of the library's modes, it is the place where the program
   uses them. *)
let place ~entry uses index (program : Ir.program) modes transitions first_mode =
  let span = program.nodes.(first_mode).span in
  let own = Own_code.is_own ~entry in
  let own_transition (t : Ir.transition) = if own t.span then Some t.span else None in
  if List.exists (fun mode -> own program.nodes.(mode).span) modes then span
  else
    match (List.find_map own_transition transitions, Own_code.use uses ~entry index) with
    | Some at, _ | None, Some (_, at) -> at
    | None, None -> entry

(* A transition of the cycle: the mode that it leaves, its target, and the signal function whose
   event causes the transition, with that function's place. *)
type hop = { from : int; target : int; by : Ir.transition; source : (string * Span.t) option }
type cycle = { entry : Span.t; program : Ir.program; modes : int array }

let mode_node cycle v = cycle.program.nodes.(cycle.modes.(v))
let is_own cycle = Own_code.is_own ~entry:cycle.entry

(* Whether a place is in the prelude. The place in the program that uses it is more helpful in a
   message. *)
let in_prelude cycle (at : Span.t) =
  String.equal (Filename.basename at.file) "Prelude.frob" && not (is_own cycle at)

let is_task cycle origin (node : Ir.node) =
  String.equal node.origin origin && Option.is_some node.machine && is_own cycle node.span

(* The name of a mode in messages. If a definition of the program runs inside a combinator, that
   definition may end, so the message uses its name. *)
let mode_name cycle hop =
  let here = mode_node cycle hop.from in
  let is_elsewhere origin (node : Ir.node) =
    let is_within =
      String.equal here.span.file node.span.file
      && Span.compare (Span.merge here.span node.span) here.span = 0
    in
    is_task cycle origin node && not is_within
  in
  let is_combinator's =
    Option.fold hop.source ~none:false ~some:(fun (_, at) -> in_prelude cycle at)
  in
  match (hop.by.by, hop.source) with
  | Statement _, Some (origin, _) when Array.exists (is_elsewhere origin) cycle.program.nodes ->
      origin
  (* a task that ends inside a combinator is named after the statement that follows it *)
  | Statement definition, _ when is_combinator's && is_own cycle hop.by.span -> definition
  | (Statement _ | Continuation _), _ -> here.origin

(* Tasks written inside a mode end when the mode ends, so the message names the mode rather than
   such a task. *)
let within_mode cycle name hop =
  let of_task (origin, at) =
    ((if Array.exists (is_task cycle origin) cycle.program.nodes then name hop.from else origin), at)
  in
  match hop.by.by with
  | Statement _ -> { hop with source = Option.map of_task hop.source }
  | Continuation _ -> hop

let by_prelude cycle hop =
  is_own cycle (mode_node cycle hop.from).span
  && Option.fold hop.source ~none:false ~some:(fun (_, at) -> in_prelude cycle at)

(* Adds the label only once if several modes with the same name have it. *)
let label ~at text (d : Diagnostic.t) =
  let there (l : Diagnostic.label) = l.at = at && String.equal l.text text in
  if List.exists there d.labels then d else Diagnostic.label ~at text d

let label_hop cycle name d hop =
  let from = name hop.from and target = name hop.target in
  let d =
    match hop.source with
    | Some _ when by_prelude cycle hop -> d
    | Some (origin, at) when origin = from ->
        label ~at (Printf.sprintf "`%s` may end at its first instant" origin) d
    | Some (origin, at) ->
        label ~at (Printf.sprintf "`%s` may occur at the first instant of `%s`" origin from) d
    | None -> d
  in
  let at = hop.by.span in
  let text =
    if from = target then Printf.sprintf "`%s` may start itself again at its own first instant" from
    else Printf.sprintf "`%s` may start `%s` at its own first instant" from target
  in
  let is_elsewhere (l : Diagnostic.label) = String.equal l.text text && l.at <> at in
  if List.exists is_elsewhere d.labels then label ~at "and again here" d else label ~at text d

let report sink ~entry uses index (program : Ir.program) first (m : Ir.machine) ~far hops =
  let cycle = { entry; program; modes = Array.of_list m.modes } in
  let hop ({ from; by } : Chains.hop) =
    let cannot_be_true = First_transitions.cannot_be_true first cycle.modes.(from) in
    {
      from;
      target = by.target;
      by;
      source = source ~cannot_be_true program (mode_node cycle from) by;
    }
  in
  let hops = map hop hops in
  let modes = map (fun hop -> cycle.modes.(hop.from)) hops in
  let names = map (fun hop -> (hop.from, mode_name cycle hop)) hops in
  let name v = List.assoc v names in
  let hops = map (within_mode cycle name) hops in
  let at = place ~entry uses index program modes (map (fun hop -> hop.by) hops) (List.hd modes) in
  let round = circle (map (fun hop -> (name hop.from, name hop.target, hop.by.by)) hops) in
  let d = Diagnostic.error ~code:"E0402" ~at "%s may repeat endlessly within one instant" round in
  let starts_there hop = Span.compare (mode_node cycle hop.from).span at = 0 in
  let d =
    if List.exists (fun hop -> by_prelude cycle hop && starts_there hop) hops then
      Diagnostic.here "this may end as soon as it starts" d
    else d
  in
  let sources = List.filter_map (fun hop -> hop.source) hops in
  let by = match hops with hop :: _ -> hop.by.by | [] -> Continuation "" in
  let event hop = if by_prelude cycle hop then None else Option.map fst hop.source in
  List.fold_left (label_hop cycle name) d hops
  |> Diagnostic.note (note (map (fun hop -> (name hop.from, event hop)) hops))
  |> far
  |> Diagnostic.hint (hint ~entry ~by sources)
  |> Diagnostic.emit sink

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

(* The hops of a cycle of modes. *)
let hops_of steps cycle =
  let hop from target : Chains.hop =
    { from; by = List.find (fun (t : Ir.transition) -> t.target = target) steps.(from) }
  in
  List.map2 hop cycle (List.tl cycle @ [ List.hd cycle ])

(* Analyzes a version of the program in which small nodes are inlined, because this is more precise.
   Its transitions correspond to those of the program. *)
let chains (program : Ir.program) (expanded, first) index m : Chains.outcome =
  let expanded : Ir.program = Lazy.force expanded in
  let by_number (t : Ir.transition) mode =
    let rec find (ours : Ir.transition list) (theirs : Ir.transition list) =
      match (ours, theirs) with
      | ours :: _, theirs :: _ when theirs == t -> ours
      | _ :: ours, _ :: theirs -> find ours theirs
      | [], _ | _, [] -> Diagnostic.bug ~stage:"Flow.Instantaneous_loops" "a transition is gone"
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

let check_machine sink ~entry uses program first expanded nodes index (m : Ir.machine) =
  let steps = First_transitions.of_machine first m in
  let graph = Array.map targets steps in
  let components = Graph.components graph in
  let report = report sink ~entry uses index program first m in
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
          report ~far:Fun.id hops;
          m
      | Goes_far ->
          let far =
            Printf.sprintf "frobc found no end within %d steps, the maximum for one instant"
              Chains.most
          in
          report ~far:(Diagnostic.note far) (hops_of steps (Graph.shortest_cycle graph component));
          m)

let program sink ~entry (program : Ir.program) =
  if Array.for_all (fun (node : Ir.node) -> Option.is_none node.machine) program.nodes then program
  else
    let first = First_transitions.of_program program in
    let uses = Own_code.uses program in
    (* If two functions have captured the same number, it becomes a single parameter. *)
    let to_look_at = lazy (Duplicate_parameters.program (Inline.to_look_at ~most:200 program)) in
    let expanded =
      (to_look_at, lazy (First_transitions.of_program ~patient:true (Lazy.force to_look_at)))
    in
    let nodes = Array.copy program.nodes in
    Array.iteri
      (fun index (node : Ir.node) ->
        let check = check_machine sink ~entry uses program first expanded nodes index in
        let machine = Option.map check node.machine in
        nodes.(index) <- { (nodes.(index)) with machine })
      program.nodes;
    { program with nodes }
