open Basis

(* Which instant is looked at: of what was just started, or of what may have
   run for any time. *)
type instant =
  | First
  | Any

type analysis = {
  program : Ir.program;
  schedules : Schedule.item list option array;
  parameters : Range.t option array array;
      (** of each node's statics, what is passed anywhere so far *)
  known : (int * instant * Range.t list * Range.t list, Range.t list) Hashtbl.t;
      (** outputs by node, statics and inputs *)
  mutable budget : int;  (** of node evaluations; then anything is possible *)
}

let budget = 200_000

let schedule a index =
  match a.schedules.(index) with
  | Some items -> items
  | None ->
      let items = Schedule.as_far_as_possible a.program.nodes.(index) in
      a.schedules.(index) <- Some items;
      items

let type_of_atom : Ir.atom -> Ir.ty = function
  | Signal s -> s.ty
  | Bool _ -> Bool
  | Int _ -> Int
  | Float _ -> Float

let map = Long_list.map

(* What is not there may be anything. *)
type values = Assumption.values

let read a (values : values) (atom : Ir.atom) =
  match (atom, Range.of_constant atom) with
  | _, Some constant -> constant
  | Signal s, None -> (
      match Hashtbl.find_opt values s.id with
      | Some range -> range
      | None -> Range.anything a.program s.ty)
  | (Bool _ | Int _ | Float _), None -> Range.anything a.program (type_of_atom atom)

let bind (values : values) signals ranges =
  List.iter2 (fun (s : Ir.signal) range -> Hashtbl.replace values s.id range) signals ranges

let anything_of a signals = map (fun (s : Ir.signal) -> Range.anything a.program s.ty) signals

(* {1 One node} *)

let equation a instant values (e : Ir.equation) =
  let read = read a values in
  let anything () = Range.anything a.program e.defines.ty in
  match (e.rhs, instant) with
  | Copy atom, _ -> read atom
  | Op (operator, arguments), _ -> Range.operation a.program.real operator (map read arguments) e.defines.ty
  | If { condition; then_; else_ }, _ -> (
      let condition = read condition in
      match (Range.may_be_true condition, Range.may_be_false condition) with
      | true, false -> read then_
      | false, _ -> read else_
      | true, true -> Range.join (read then_) (read else_))
  | Construct { constructor; payload }, _ ->
      Constructors [ (constructor, Some (map read payload)) ]
  | Is_constructor (value, constructor), _ -> Range.has_constructor (read value) constructor
  | Payload { value; constructor; leaf }, _ -> (
      match Range.payload (read value) constructor leaf with
      | Some known -> known
      | None -> anything ())
  | Absent, _ -> anything ()
  | Elements atoms, _ -> (
      match map read atoms with
      | [] -> anything ()
      | first :: others -> List.fold_left Range.join first others)
  | Fill a, _ | Index (a, _), _ -> read a
  | At { array; default; index = _ }, _ -> Range.join (read array) (read default)
  | Replace { array; value; index = _ }, _ -> Range.join (read array) (read value)
  | Delay { init; _ }, First -> read init
  | (Time _ | Integral _ | Derivative _), First -> Range.zero
  | Time _, Any -> Range.not_negative
  | Ticks _, _ -> anything ()
  | (Delay _ | Integral _ | Derivative _), Any -> anything ()

(* The transitions that may be the first to occur. *)
let possible a instant node values (transitions : Ir.transition list) =
  let equations =
    lazy
      (List.filter_map
         (function
           | Schedule.Equation e -> Some e
           | Instance _ | Trial _ | Machine _ -> None)
         (schedule a node))
  in
  let at_once before (t : Ir.transition) =
    let not_before (t : Ir.transition) = (t.occurs, false) in
    Assumption.possible values ~read:(read a) ~evaluate:(equation a instant)
      (Lazy.force equations)
      ((t.occurs, true) :: List.rev_map not_before before)
  in
  let rec first before = function
    | [] -> []
    | (t : Ir.transition) :: others ->
        let occurs = read a values t.occurs in
        if not (Range.may_be_true occurs) then first before others
        else if not (Range.may_be_false occurs) then if at_once before t then [ t ] else []
        else if at_once before t then t :: first (t :: before) others
        else first (t :: before) others
  in
  first [] transitions

let parameters a index =
  List.mapi
    (fun j (s : Ir.signal) ->
      Option.value a.parameters.(index).(j) ~default:(Range.anything a.program s.ty))
    a.program.nodes.(index).statics

(* Of all rounds of a loop together. *)
let inputs_of a values (i : Ir.instance) =
  match i.loop with
  | None -> map (read a values) i.inputs
  | Some l ->
      let input (argument : Ir.argument) atom =
        match argument with
        | Element | Same -> read a values atom
        | Accumulator | Counter -> Range.anything a.program (type_of_atom atom)
      in
      List.map2 input l.arguments i.inputs

let rec outputs a instant index ~statics ~inputs =
  let node = a.program.nodes.(index) in
  let key = (index, instant, statics, inputs) in
  match Hashtbl.find_opt a.known key with
  | Some outputs -> outputs
  | None ->
      let found =
        if a.budget <= 0 then
          map (fun (_, atom) -> Range.anything a.program (type_of_atom atom)) node.outputs
        else
          let values = evaluate a instant index ~statics ~inputs in
          map (fun (_, atom) -> read a values atom) node.outputs
      in
      Hashtbl.replace a.known key found;
      found

and evaluate a instant index ~statics ~inputs =
  a.budget <- a.budget - 1;
  let node = a.program.nodes.(index) in
  let values : values = Hashtbl.create 32 in
  bind values node.statics statics;
  bind values node.inputs inputs;
  List.iter
    (fun (item : Schedule.item) ->
      match item with
      | Equation e -> Hashtbl.replace values e.defines.id (equation a instant values e)
      | Instance i ->
          let statics = map (read a values) i.statics in
          let inputs = inputs_of a values i in
          let outputs = outputs a instant i.node ~statics ~inputs in
          bind values i.outputs outputs
      | Trial (_, trial) -> bind values trial.gives (anything_of a trial.gives)
      | Machine m -> bind values m.outputs (machine a instant index values m))
    (schedule a index);
  values

(* The outputs of a machine at its own first instant: those of all modes in
   which it may come to stay. *)
and machine a instant index values (m : Ir.machine) =
  match (instant, m.active) with
  | Any, _ | First, Some _ -> anything_of a m.outputs
  | First, None ->
      let modes = Array.of_list m.modes in
      let inputs = map (read a values) m.inputs in
      let seen = Array.make (Array.length modes) false in
      let results = ref None in
      let add found =
        results :=
          Some
            (match !results with
            | None -> found
            | Some before -> List.rev (List.rev_map2 Range.join before found))
      in
      let rec visit target =
        if not seen.(target) then (
          seen.(target) <- true;
          let index = modes.(target) in
          let node = a.program.nodes.(index) in
          let inside = evaluate a First index ~statics:(parameters a index) ~inputs in
          let next = possible a First index inside node.transitions in
          let stays (t : Ir.transition) = t.delayed || Range.may_be_false (read a inside t.occurs) in
          if List.for_all stays next then
            add (map (fun (_, atom) -> read a inside atom) node.outputs);
          List.iter (fun (t : Ir.transition) -> if not t.delayed then visit t.target) next)
      in
      let enter (t : Ir.transition) = visit t.target in
      let controls = possible a instant index values m.controls in
      let strict = List.filter (fun (t : Ir.transition) -> not t.delayed) controls in
      List.iter enter strict;
      let surely (t : Ir.transition) = not (Range.may_be_false (read a values t.occurs)) in
      if not (List.exists surely strict) then List.iter enter (possible a instant index values m.start);
      Option.value !results ~default:(anything_of a m.outputs)

(* {1 Parameters} *)

let pass a ~widening index ranges =
  let changed = ref false in
  List.iteri
    (fun j range ->
      let before = a.parameters.(index).(j) in
      let after =
        match before with
        | None -> range
        | Some before -> (if widening then Range.widen else Range.join) before range
      in
      if before <> Some after then (
        a.parameters.(index).(j) <- Some after;
        changed := true))
    ranges;
  !changed

let rounds = 3

(* What modes pass to each other, in circles. *)
let parameters_of_modes a values (m : Ir.machine) =
  let modes = Array.of_list m.modes in
  let send ~widening values (t : Ir.transition) =
    pass a ~widening modes.(t.target) (map (read a values) t.arguments)
  in
  let rec again round =
    let widening = round > rounds in
    let send_all values transitions =
      List.fold_left (fun changed t -> send ~widening values t || changed) false transitions
    in
    let from_mode changed index =
      let node = a.program.nodes.(index) in
      let reached =
        List.for_all (fun j -> Option.is_some a.parameters.(index).(j))
          (List.mapi (fun j _ -> j) node.statics)
      in
      if node.transitions = [] || not reached then changed
      else
        let inside =
          evaluate a Any index ~statics:(parameters a index) ~inputs:(anything_of a node.inputs)
        in
        send_all inside node.transitions || changed
    in
    let changed = send_all values m.start in
    let changed = send_all values m.controls || changed in
    if Array.fold_left from_mode changed modes && a.budget > 0 then again (round + 1)
  in
  if Array.exists (fun index -> a.program.nodes.(index).statics <> []) modes then again 1

(* Callers come before callees here. *)
let pass_parameters a =
  for index = Array.length a.program.nodes - 1 downto 0 do
    let node = a.program.nodes.(index) in
    let inputs = anything_of a node.inputs in
    let passes (i : Ir.instance) = i.statics <> [] in
    if List.exists passes node.instances || Option.is_some node.machine then (
      let values = evaluate a Any index ~statics:(parameters a index) ~inputs in
      List.iter
        (fun (i : Ir.instance) ->
          ignore (pass a ~widening:false i.node (map (read a values) i.statics)))
        node.instances;
      Option.iter (parameters_of_modes a values) node.machine)
  done

(* {1 Circles} *)

(* The transitions that each mode may take at its own first instant. *)
let at_first_instants a (m : Ir.machine) =
  let of_mode index =
    let node = a.program.nodes.(index) in
    if node.transitions = [] then []
    else
      let values =
        evaluate a First index ~statics:(parameters a index) ~inputs:(anything_of a node.inputs)
      in
      possible a First index values node.transitions
  in
  Array.of_list (map of_mode m.modes)

let targets = map (fun (t : Ir.transition) -> t.target)

(* The signal function whose event makes a transition occur, as far as one can
   follow it in the mode itself; not one that is known not to do so at the first
   instant, among these [values]. *)
let source ?values a (node : Ir.node) (t : Ir.transition) =
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
  let surely_false (s : Ir.signal) =
    match Option.map (fun values -> read a values (Signal s)) values with
    | Some (Range.Bools { true_ = false; _ }) -> true
    | Some _ | None -> false
  in
  let rec search = function
    | [] -> None
    | (s : Ir.signal) :: others when Hashtbl.mem seen s.id || surely_false s -> search others
    | s :: others -> (
        Hashtbl.replace seen s.id ();
        match Hashtbl.find_opt definer s.id with
        | None | Some (Schedule.Machine _ | Trial _) -> search others
        | Some (Equation e) -> search (others @ Operands.(signals (same_instant e.rhs)))
        | Some (Instance i) -> (
            match a.program.nodes.(i.node) with
            | { kind = Signal_function; origin; _ } -> Some (origin, i.span)
            | { kind = Function; _ } -> search (others @ Operands.signals i.inputs)))
  in
  search (Operands.signals [ t.occurs ])

(* The prelude's [after] and [now] are what one meets first inside them. *)
let hint sources =
  match sources with
  | "after" :: _ -> "a time of at least 1 ns makes it wait: `after (max 1[ms] q)`"
  | "when" :: _ -> "`edge` occurs when a condition becomes True, not at the first instant"
  | "elapsed" :: _ -> "a time of at least 1 ns makes it wait: `max 1[ms] q`"
  | [] ->
      "something in the circle has to take time: `edge` or `notYet` on an event, `sleepT 10[ms] y` \
       between tasks"
  | _ ->
      "`notYet` drops an occurrence at the first instant; `edge` has none there; `sleepT 10[ms] y` \
       takes time between tasks"

(* A mode of a switch is left by an event, a task ends: both start what comes next. *)
let circle names =
  let different =
    List.rev
      (List.fold_left (fun found name -> if List.mem name found then found else name :: found) [] names)
  in
  match different with
  | [ one ] -> Printf.sprintf "`%s` may start itself again" one
  | [ one; other ] -> Printf.sprintf "`%s` and `%s` may start each other" one other
  | one :: others ->
      Printf.sprintf "`%s` and %d others may start each other" one (List.length others)
  | [] -> Diagnostic.bug ~stage:"Flow.Instantaneous_loops" "a circle without modes"

let report sink a (m : Ir.machine) steps cycle =
  let modes = Array.of_list m.modes in
  let name k = a.program.nodes.(modes.(k)).origin in
  let rec pairs first = function
    | v :: (w :: _ as rest) -> (v, w) :: pairs first rest
    | [ last ] -> [ (last, first) ]
    | [] -> []
  in
  let hops = pairs (List.hd cycle) cycle in
  let hop (v, w) =
    let t = List.find (fun (t : Ir.transition) -> t.target = w) steps.(v) in
    let node = a.program.nodes.(modes.(v)) in
    let values =
      evaluate a First modes.(v) ~statics:(parameters a modes.(v))
        ~inputs:(anything_of a node.inputs)
    in
    (v, w, t, source ~values a node t)
  in
  let hops = map hop hops in
  let d =
    Diagnostic.error ~code:"E0402" ~at:a.program.nodes.(modes.(List.hd cycle)).span
      "%s for ever within one instant" (circle (map name cycle))
  in
  (* Once, where modes of one name do the same. *)
  let label ~at text (d : Diagnostic.t) =
    let there (l : Diagnostic.label) = l.at = at && String.equal l.text text in
    if List.exists there d.labels then d else Diagnostic.label ~at text d
  in
  let label d (v, w, (t : Ir.transition), source) =
    let d =
      match source with
      | Some (origin, at) ->
          label ~at
            (Printf.sprintf "`%s` may occur at the first instant of `%s`" origin (name v))
            d
      | None -> d
    in
    label ~at:t.span
      (Printf.sprintf "`%s` may start `%s` at its own first instant" (name v) (name w))
      d
  in
  let sources = List.filter_map (fun (_, _, _, source) -> Option.map fst source) hops in
  List.fold_left label d hops |> Diagnostic.hint (hint sources) |> Diagnostic.emit sink

(* {1 Bounds} *)

(* How many modes are stepped at most, from entering each. The components come
   in an order in which targets are before sources. *)
let chains graph components =
  let chain = Array.make (Array.length graph) 1 in
  List.iter
    (List.iter (fun v ->
         chain.(v) <- List.fold_left (fun n w -> max n (1 + chain.(w))) 1 graph.(v)))
    components;
  chain

let bound a (m : Ir.machine) chain =
  let entering (t : Ir.transition) = chain.(t.target) in
  let longest = List.fold_left (fun n t -> max n (entering t)) 0 in
  let running =
    List.fold_left
      (fun n index -> max n (1 + longest a.program.nodes.(index).transitions))
      1 m.modes
  in
  let running = max running (longest m.start) in
  let late, strict = List.partition (fun (t : Ir.transition) -> t.delayed) m.controls in
  max (running + longest late) (longest strict)

(* The modes' transitions that cannot occur at a first instant are marked. *)
let mark a (nodes : Ir.node array) (m : Ir.machine) steps =
  List.iteri
    (fun k index ->
      let node = a.program.nodes.(index) in
      let transition (t : Ir.transition) =
        if List.memq t steps.(k) then t
        else { t with at_entry = Impossible (source a node t) }
      in
      nodes.(index) <- { nodes.(index) with transitions = map transition node.transitions })
    m.modes

let check_machine sink a nodes (m : Ir.machine) =
  let steps = at_first_instants a m in
  mark a nodes m steps;
  let graph = Array.map targets steps in
  let components = Graph.components graph in
  List.iter
    (fun component ->
      if Graph.is_cyclic graph component then
        report sink a m steps (Graph.shortest_cycle graph component))
    components;
  { m with steps = bound a m (chains graph components) }

let program sink (program : Ir.program) =
  if Array.for_all (fun (node : Ir.node) -> Option.is_none node.machine) program.nodes then program
  else
    let count = Array.length program.nodes in
    let a =
      {
        program;
        schedules = Array.make count None;
        parameters =
          Array.map
            (fun (node : Ir.node) -> Array.make (List.length node.statics) None)
            program.nodes;
        known = Hashtbl.create 256;
        budget;
      }
    in
    pass_parameters a;
    (* Where the work was too much nothing is known of parameters. *)
    if a.budget <= 0 then Array.iter (fun p -> Array.fill p 0 (Array.length p) None) a.parameters;
    (* What was found on the way rested on parameters not yet all known. *)
    Hashtbl.reset a.known;
    a.budget <- budget;
    let nodes = Array.copy program.nodes in
    Array.iteri
      (fun index (node : Ir.node) ->
        let machine = Option.map (check_machine sink a nodes) node.machine in
        nodes.(index) <- { (nodes.(index)) with machine })
      program.nodes;
    { program with nodes }
