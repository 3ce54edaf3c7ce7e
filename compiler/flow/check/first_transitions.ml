open Basis

(* The instant to evaluate: the first one after the start, or any instant. *)
type instant = First | Any

type t = {
  program : Ir.program;
  schedules : Schedule.item list option array;
  parameters : Range.t option array array;
      (** for each node, the range of each static parameter, joined over all calls seen so far *)
  arguments : Range.t list option array;
      (** for each node, the ranges of its inputs in any instant, joined in the same way; unknown
          for modes *)
  known : (int * instant * Range.t list * Range.t list, Range.t list) Hashtbl.t;
      (** cached ranges of outputs, by node, instant, static parameters and inputs *)
  steps : int list Lazy.t;
      (** widening thresholds: the bounds of Ints are first widened to these values *)
  mutable budget : int;
      (** number of node evaluations left; when it reaches 0, everything is assumed to be possible
      *)
  mutable parameters_known : bool;
      (** whether the budget was sufficient to compute all parameters *)
}

let budget = 200_000

let schedule a index =
  match a.schedules.(index) with
  | Some items -> items
  | None ->
      let items = Schedule.as_far_as_possible a.program.nodes.(index) in
      a.schedules.(index) <- Some items;
      items

let map = Long_list.map

(* A signal that is not in this table may have any value. *)
type values = Assumption.values

(* Maps a signal to an equal signal of the same node. *)
type same = (int, int) Hashtbl.t

let same_as (same : same) (s : Ir.signal) = Option.value (Hashtbl.find_opt same s.id) ~default:s.id

let read a (values : values) (atom : Ir.atom) =
  let known =
    match atom with
    | Signal s -> Hashtbl.find_opt values s.id
    | Bool _ | Int _ | Float _ -> Range.of_constant atom
  in
  match known with Some range -> range | None -> Range.anything a.program (Operands.ty atom)

let bind (values : values) signals ranges =
  List.iter2 (fun (s : Ir.signal) range -> Hashtbl.replace values s.id range) signals ranges

let joined before ranges =
  match before with
  | None -> ranges
  | Some before -> List.rev (List.rev_map2 Range.join before ranges)

let anything_of a signals = map (fun (s : Ir.signal) -> Range.anything a.program s.ty) signals

(* {1 One node} *)

(* The result of an operation whose two operands are the same number, if it can be determined. *)
let on_itself (operator : Ir.operator) (x : Range.t) : Range.t option =
  let regular =
    match x with Floats { nan; _ } -> not nan | Ints _ | Bools _ | Constructors _ -> true
  in
  match (operator, x) with
  | Subtract, Floats { least; most; nan } ->
      Some (Range.zero_or ~nan:(nan || least = neg_infinity || most = infinity))
  | Subtract, Ints _ -> Some (Ints { least = 0; most = 0 })
  | Less, _ -> Some (Bools { true_ = false; false_ = true })
  | (Less_equal | Equal), _ -> Some (Bools { true_ = true; false_ = not regular })
  | _ -> None

let are_same (same : same) (arguments : Ir.atom list) =
  match arguments with [ Signal s; Signal t ] -> same_as same s = same_as same t | _ -> false

let note_same (same : same) (e : Ir.equation) =
  let is (s : Ir.signal) = Hashtbl.replace same e.defines.id (same_as same s) in
  match e.rhs with
  | Copy (Signal s) -> is s
  | If { then_ = Signal s; else_ = Signal t; _ } when same_as same s = same_as same t -> is s
  | _ -> ()

let equation a instant same values (e : Ir.equation) =
  let read = read a values in
  let anything () = Range.anything a.program e.defines.ty in
  match (e.rhs, instant) with
  | Copy atom, _ -> read atom
  | Op (operator, (x :: _ as arguments)), _
    when are_same same arguments && on_itself operator (read x) <> None ->
      Option.get (on_itself operator (read x))
  | Op (operator, arguments), _ ->
      Range.operation a.program.real operator (map read arguments) e.defines.ty
  | If { condition; then_; else_ }, _ -> (
      let condition = read condition in
      match (Range.may_be_true condition, Range.may_be_false condition) with
      | true, false -> read then_
      | false, _ -> read else_
      | true, true -> Range.join (read then_) (read else_))
  | Construct { constructor; payload }, _ -> Constructors [ (constructor, Some (map read payload)) ]
  | Is_constructor (value, constructor), _ -> Range.has_constructor (read value) constructor
  | Payload { value; constructor; leaf }, _ -> (
      match Range.payload (read value) constructor leaf with
      | Some known -> known
      | None -> anything ())
  | (Param _ | Absent), _ -> anything ()
  | Elements atoms, _ -> (
      match map read atoms with
      | [] -> anything ()
      | first :: others -> List.fold_left Range.join first others)
  | Fill a, _ | Index (a, _), _ -> read a
  | At { array; default; index = _ }, _ -> Range.join (read array) (read default)
  | Replace { array; value; index = _ }, _ -> Range.join (read array) (read value)
  | Delay { init; _ }, First -> read init
  | (Time _ | Step_time | Integral _ | Derivative _), First -> Range.zero
  | (Time _ | Step_time), Any -> Range.not_negative
  | Ticks _, _ -> anything ()
  | (Delay _ | Integral _ | Derivative _), Any -> anything ()

(* The result of evaluating a node in an instant. *)
type evaluated = { values : values; same : same }

(* The transitions that may be the first to occur, each with the possible values of signals in that
   case. *)
let possible a instant node { values; same } (transitions : Ir.transition list) =
  let equations =
    lazy
      (List.filter_map
         (function Schedule.Equation e -> Some e | Instance _ | Trial _ | Machine _ -> None)
         (schedule a node))
  in
  let at_once before (t : Ir.transition) =
    let not_before (t : Ir.transition) = (t.occurs, false) in
    Assumption.narrowed values ~read:(read a) ~evaluate:(equation a instant same)
      (Lazy.force equations)
      ((t.occurs, true) :: List.rev_map not_before before)
    |> Option.map (fun values -> (t, { values; same }))
  in
  let rec first before = function
    | [] -> []
    | (t : Ir.transition) :: others ->
        let occurs = read a values t.occurs in
        if not (Range.may_be_true occurs) then first before others
        else
          let here = Option.to_list (at_once before t) in
          if Range.may_be_false occurs then here @ first (t :: before) others else here
  in
  first [] transitions

let parameters a index =
  List.mapi
    (fun j (s : Ir.signal) ->
      Option.value a.parameters.(index).(j) ~default:(Range.anything a.program s.ty))
    a.program.nodes.(index).statics

(* Whether any call or transition leads to this node. Always true for a node without static
   parameters. *)
let is_entered a index = Array.for_all Option.is_some a.parameters.(index)

let arguments a index =
  match a.arguments.(index) with
  | Some ranges -> ranges
  | None -> anything_of a a.program.nodes.(index).inputs

(* The ranges of an instance's inputs; for a loop, those in any iteration. *)
let inputs_of a values (i : Ir.instance) =
  match i.loop with
  | None -> map (read a values) i.inputs
  | Some l ->
      let input (argument : Ir.argument) atom =
        match argument with
        | Element | Same -> read a values atom
        | Accumulator | Counter -> Range.anything a.program (Operands.ty atom)
      in
      List.map2 input l.arguments i.inputs

(* For each atom, the index of the first atom equal to it; an empty list if all are different. *)
let pattern_of same (atoms : Ir.atom list) =
  let first = Hashtbl.create 16 in
  let number i : Ir.atom -> int = function
    | Signal s -> (
        let id = same_as same s in
        match Hashtbl.find_opt first id with
        | Some j -> j
        | None ->
            Hashtbl.replace first id i;
            i)
    | Bool _ | Int _ | Float _ -> i
  in
  let numbers = List.mapi number atoms in
  if List.mapi (fun i _ -> i) atoms = numbers then [] else numbers

let rec outputs a instant index ~statics ~inputs =
  let node = a.program.nodes.(index) in
  let key = (index, instant, statics, inputs) in
  match Hashtbl.find_opt a.known key with
  | Some outputs -> outputs
  | None ->
      let found =
        if a.budget <= 0 then
          map (fun (_, atom) -> Range.anything a.program (Operands.ty atom)) node.outputs
        else
          let { values; _ } = evaluate a instant index ~statics ~inputs in
          map (fun (_, atom) -> read a values atom) node.outputs
      in
      Hashtbl.replace a.known key found;
      found

(* [pattern] states which static parameters and inputs are equal (see [pattern_of]). *)
and evaluate ?(pattern = []) a instant index ~statics ~inputs =
  a.budget <- a.budget - 1;
  let node = a.program.nodes.(index) in
  let values : values = Hashtbl.create 32 and same : same = Hashtbl.create 16 in
  bind values node.statics statics;
  bind values node.inputs inputs;
  (if pattern <> [] then
     let formals = Array.of_list (node.statics @ node.inputs) in
     let is_same i j = if i <> j then Hashtbl.replace same formals.(i).id formals.(j).id in
     List.iteri is_same pattern);
  List.iter
    (fun (item : Schedule.item) ->
      match item with
      | Equation e ->
          note_same same e;
          Hashtbl.replace values e.defines.id (equation a instant same values e)
      | Instance i ->
          let statics = map (read a values) i.statics in
          let inputs = inputs_of a values i in
          let outputs = outputs a instant i.node ~statics ~inputs in
          bind values i.outputs outputs
      | Trial (_, trial) -> bind values trial.gives (anything_of a trial.gives)
      | Machine m -> bind values m.outputs (machine a instant index values m))
    (schedule a index);
  { values; same }

(* The outputs of a machine in its first instant: the join over all modes in which it may end up. *)
and machine a instant index values (m : Ir.machine) =
  match (instant, m.active) with
  | Any, _ | First, Some _ -> anything_of a m.outputs
  | First, None ->
      let modes = Array.of_list m.modes in
      let inputs = map (read a values) m.inputs in
      let seen = Array.make (Array.length modes) false in
      let results = ref None in
      let add found = results := Some (joined !results found) in
      let rec visit target =
        if not seen.(target) then (
          seen.(target) <- true;
          let index = modes.(target) in
          let node = a.program.nodes.(index) in
          let inside = evaluate a First index ~statics:(parameters a index) ~inputs in
          let next = map fst (possible a First index inside node.transitions) in
          let inside = inside.values in
          let stays (t : Ir.transition) =
            t.delayed || Range.may_be_false (read a inside t.occurs)
          in
          if List.for_all stays next then
            add (map (fun (_, atom) -> read a inside atom) node.outputs);
          List.iter (fun (t : Ir.transition) -> if not t.delayed then visit t.target) next)
      in
      let enter (t : Ir.transition) = visit t.target in
      let possible transitions =
        map fst (possible a instant index { values; same = Hashtbl.create 1 } transitions)
      in
      let controls = possible m.controls in
      let strict = List.filter (fun (t : Ir.transition) -> not t.delayed) controls in
      List.iter enter strict;
      let surely (t : Ir.transition) = not (Range.may_be_false (read a values t.occurs)) in
      if not (List.exists surely strict) then List.iter enter (possible m.start);
      Option.value !results ~default:(anything_of a m.outputs)

(* {1 Parameters} *)

let most_steps = 200

(* Programs mostly compare Ints with literals, so the literals of a program are good bounds. *)
let literals (program : Ir.program) =
  let add found : Ir.atom -> int list = function
    | Int n ->
        let n = Int32.to_int n in
        (n - 1) :: n :: (n + 1) :: found
    | Bool _ | Float _ | Signal _ -> found
  in
  let of_equation found (e : Ir.equation) = List.fold_left add found (Operands.all e.rhs) in
  let of_node found (node : Ir.node) = List.fold_left of_equation found node.equations in
  let all = List.sort_uniq Int.compare (Array.fold_left of_node [] program.nodes) in
  List.filteri (fun i _ -> i < most_steps) all

let pass a ~widening index ranges =
  let changed = ref false in
  List.iteri
    (fun j range ->
      let before = a.parameters.(index).(j) in
      let after =
        match before with
        | None -> range
        | Some before when widening -> Range.widen ~steps:(Lazy.force a.steps) before range
        | Some before -> Range.join before range
      in
      if before <> Some after then (
        a.parameters.(index).(j) <- Some after;
        changed := true))
    ranges;
  !changed

let rounds = 3

(* Computes the parameters that modes pass to each other, until nothing changes. *)
let parameters_of_modes a values (m : Ir.machine) =
  let modes = Array.of_list m.modes in
  let send ~widening ((t : Ir.transition), { values; _ }) =
    pass a ~widening modes.(t.target) (map (read a values) t.arguments)
  in
  let rec again round =
    let widening = round > rounds in
    let send_all transitions =
      List.fold_left (fun changed t -> send ~widening t || changed) false transitions
    in
    let unconditional = map (fun t -> (t, { values; same = Hashtbl.create 1 })) in
    let from_mode changed index =
      let node = a.program.nodes.(index) in
      if node.transitions = [] || not (is_entered a index) then changed
      else
        let inside =
          evaluate a Any index ~statics:(parameters a index) ~inputs:(anything_of a node.inputs)
        in
        send_all (possible a Any index inside node.transitions) || changed
    in
    let changed = send_all (unconditional m.start) in
    let changed = send_all (unconditional m.controls) || changed in
    if Array.fold_left from_mode changed modes && a.budget > 0 then again (round + 1)
  in
  if Array.exists (fun index -> a.program.nodes.(index).statics <> []) modes then again 1

(* In a trial step, inputs that do not affect the result may have any value. *)
let with_trials a (i : Ir.instance) ranges =
  let on_trial ranges (trial : Ir.trial) =
    List.map2 (fun range -> function Some _ -> range | None -> None) ranges trial.given
  in
  let known = List.fold_left on_trial (map Option.some ranges) i.trials in
  List.map2
    (fun range (s : Ir.signal) -> Option.value range ~default:(Range.anything a.program s.ty))
    known a.program.nodes.(i.node).inputs

let pass_inputs a index ranges = a.arguments.(index) <- Some (joined a.arguments.(index) ranges)

(* For each node, whether it contains a machine, directly or through its instances. Inputs are
   computed only for such nodes. *)
let with_machines (program : Ir.program) =
  let found = Array.make (Array.length program.nodes) false in
  Array.iteri
    (fun index (node : Ir.node) ->
      let has (i : Ir.instance) = found.(i.node) in
      found.(index) <- Option.is_some node.machine || List.exists has node.instances)
    program.nodes;
  found

(* Visits callers before callees. Skips nodes that are never called and modes that are never
   entered, because they pass no parameters. *)
let pass_parameters a =
  let last = Array.length a.program.nodes - 1 in
  let with_machines = with_machines a.program in
  let is_called = Array.make (last + 1) false in
  is_called.(last) <- true;
  for index = last downto 0 do
    let node = a.program.nodes.(index) in
    if is_called.(index) then
      List.iter (fun (i : Ir.instance) -> is_called.(i.node) <- true) node.instances;
    let passes (i : Ir.instance) = i.statics <> [] || with_machines.(i.node) in
    let hands_on = List.exists passes node.instances || Option.is_some node.machine in
    if is_called.(index) && hands_on then (
      let inputs = arguments a index in
      let { values; _ } = evaluate a Any index ~statics:(parameters a index) ~inputs in
      List.iter
        (fun (i : Ir.instance) ->
          ignore (pass a ~widening:false i.node (map (read a values) i.statics));
          if with_machines.(i.node) then
            pass_inputs a i.node (with_trials a i (inputs_of a values i)))
        node.instances;
      let of_machine (m : Ir.machine) =
        List.iter
          (fun mode -> pass_inputs a mode (anything_of a a.program.nodes.(mode).inputs))
          m.modes;
        parameters_of_modes a values m;
        List.iter (fun mode -> if is_entered a mode then is_called.(mode) <- true) m.modes
      in
      Option.iter of_machine node.machine)
  done

(* {1 First instants of modes} *)

let at_first_instant a index =
  evaluate a First index ~statics:(parameters a index)
    ~inputs:(anything_of a a.program.nodes.(index).inputs)

(* Whether this is a mode that no possible transition enters. *)
let never_runs a index = a.parameters_known && not (is_entered a index)

let of_machine a (m : Ir.machine) =
  let of_mode index =
    let node = a.program.nodes.(index) in
    if node.transitions = [] || never_runs a index then []
    else map fst (possible a First index (at_first_instant a index) node.transitions)
  in
  Array.of_list (map of_mode m.modes)

type state = { mode : int; known : Range.t list; pattern : int list }

let entered a inputs ((t : Ir.transition), { values; same }) =
  let atoms = t.arguments @ inputs in
  (t, { mode = t.target; known = map (read a values) atoms; pattern = pattern_of same atoms })

let of_running a ?controls index inputs =
  let node = a.program.nodes.(index) in
  let inside = evaluate a Any index ~statics:(parameters a index) ~inputs:(arguments a index) in
  let transitions = Option.value controls ~default:node.transitions in
  map (entered a inputs) (possible a Any index inside transitions)

let signals = map (fun s -> Ir.Signal s)

let from_running a index =
  if never_runs a index then [] else of_running a index (signals a.program.nodes.(index).inputs)

let from_owner a index (m : Ir.machine) transitions =
  of_running a ~controls:transitions index m.inputs

let from_state a index state =
  let node = a.program.nodes.(index) in
  if node.transitions = [] then []
  else
    let count = List.length node.statics in
    let statics, inputs = Long_list.split_at count state.known in
    let inside = evaluate a First index ~statics ~inputs ~pattern:state.pattern in
    map (entered a (signals node.inputs)) (possible a First index inside node.transitions)

let cannot_be_true a index =
  let { values; _ } = at_first_instant a index in
  fun (s : Ir.signal) ->
    match read a values (Signal s) with
    | Bools { true_; false_ = _ } -> not true_
    | Ints _ | Floats _ | Constructors _ -> false

let of_program ?(patient = false) (program : Ir.program) =
  let count = Array.length program.nodes in
  let a =
    {
      program;
      schedules = Array.make count None;
      parameters =
        Array.map (fun (node : Ir.node) -> Array.make (List.length node.statics) None) program.nodes;
      arguments = Array.make count None;
      known = Hashtbl.create 256;
      steps = lazy (if patient then literals program else []);
      budget;
      parameters_known = false;
    }
  in
  pass_parameters a;
  a.parameters_known <- a.budget > 0;
  (* If the budget was not sufficient, treats all parameters as unknown. *)
  if not a.parameters_known then (
    Array.iter (fun p -> Array.fill p 0 (Array.length p) None) a.parameters;
    Array.fill a.arguments 0 count None);
  (* Discards cached results, which were computed with incomplete parameters. *)
  Hashtbl.reset a.known;
  a.budget <- budget;
  a
