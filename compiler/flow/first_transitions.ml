open Basis

(* Which instant is looked at: of what was just started, or of what may have
   run for any time. *)
type instant =
  | First
  | Any

type t = {
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

(* {1 First instants of modes} *)

let at_first_instant a index =
  evaluate a First index ~statics:(parameters a index)
    ~inputs:(anything_of a a.program.nodes.(index).inputs)

let of_machine a (m : Ir.machine) =
  let of_mode index =
    let node = a.program.nodes.(index) in
    if node.transitions = [] then []
    else possible a First index (at_first_instant a index) node.transitions
  in
  Array.of_list (map of_mode m.modes)

let cannot_be_true a index =
  let values = at_first_instant a index in
  fun (s : Ir.signal) ->
    match read a values (Signal s) with
    | Bools { true_; false_ = _ } -> not true_
    | Ints _ | Floats _ | Constructors _ -> false

let of_program (program : Ir.program) =
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
  a
