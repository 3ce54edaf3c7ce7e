open Basis

let bug format = Diagnostic.bug ~stage:"Flow.Lint" format

type scope = {
  program : Ir.program;
  index : int; (* index of the node *)
  node : Ir.node;
  defined : (int, Ir.signal) Hashtbl.t;
}

let define owners scope (s : Ir.signal) =
  (match Hashtbl.find_opt owners s.id with
  | Some owner ->
      bug "signal %d (`%s`) is defined in `%s` and in `%s`" s.id s.name owner scope.node.Ir.name
  | None -> ());
  Hashtbl.add owners s.id scope.node.name;
  Hashtbl.add scope.defined s.id s

let show scope = Print.ty scope.program.sums

let type_of scope (a : Ir.atom) : Ir.ty =
  match a with
  | Bool _ -> Bool
  | Int _ -> Int
  | Float _ -> Float
  | Signal s -> (
      match Hashtbl.find_opt scope.defined s.id with
      | None -> bug "signal %d (`%s`) has no equation in `%s`" s.id s.name scope.node.name
      | Some defined ->
          if defined.ty <> s.ty then bug "signal `%s` has two types in `%s`" s.name scope.node.name;
          s.ty)

let expect scope what (expected : Ir.ty) (found : Ir.ty) =
  if expected <> found then
    bug "%s in `%s` is a %s where a %s is needed" what scope.node.name (show scope found)
      (show scope expected)

(* The types of the payload's leaves. *)
let payload scope (ty : Ir.ty) index =
  match ty with
  | Bool | Int | Float | Array _ | Foreign _ ->
      bug "a %s has no constructors in `%s`" (show scope ty) scope.node.name
  | Sum sum -> (
      match List.nth_opt scope.program.sums.(sum).constructors index with
      | Some c -> Shape.payload c
      | None -> bug "%s has no constructor %d" (show scope ty) index)

let operator scope operator arguments =
  match Operator_type.result operator arguments with
  | Some ty -> ty
  | None ->
      bug "`%s` is applied to (%s) in `%s`" (Print.operator operator)
        (String.concat ", " (List.map (show scope) arguments))
        scope.node.name

let check_all scope what expected atoms =
  if List.compare_lengths expected atoms <> 0 then
    bug "%s in `%s`: %d values where %d are needed" what scope.node.name (List.length atoms)
      (List.length expected);
  List.iter2 (fun ty atom -> expect scope what ty (type_of scope atom)) expected atoms

let stateful scope what =
  if scope.node.kind = Function then bug "the function `%s` has state: %s" scope.node.name what

(* Checks that values of this type may be stored in the state. *)
let lasting scope ty =
  match Shape.of_the_instant scope.program.sums ty with
  | Some f -> bug "a `%s` outlives the instant in `%s`" f.foreign_name scope.node.name
  | None -> ()

let array scope a =
  match type_of scope a with
  | Array (n, element) -> (n, element)
  | other -> bug "a %s is used as an array in `%s`" (show scope other) scope.node.name

let equation scope (eq : Ir.equation) =
  let ty = eq.defines.ty in
  let found : Ir.ty =
    match eq.rhs with
    | Copy a -> type_of scope a
    | Op (op, arguments) -> operator scope op (List.map (type_of scope) arguments)
    | If { condition; then_; else_ } ->
        expect scope "a condition" Bool (type_of scope condition);
        expect scope "a branch" ty (type_of scope else_);
        type_of scope then_
    | Construct { constructor; payload = atoms } ->
        check_all scope "a payload" (payload scope ty constructor) atoms;
        ty
    | Is_constructor (a, index) ->
        ignore (payload scope (type_of scope a) index);
        Bool
    | Payload { value; constructor; leaf } -> (
        match List.nth_opt (payload scope (type_of scope value) constructor) leaf with
        | Some ty -> ty
        | None -> bug "a payload has no leaf %d in `%s`" leaf scope.node.name)
    | Elements atoms -> (
        match ty with
        | Array (n, element) when List.length atoms = n ->
            List.iter (fun a -> expect scope "an element" element (type_of scope a)) atoms;
            ty
        | _ ->
            bug "%d elements do not form a %s in `%s`" (List.length atoms) (show scope ty)
              scope.node.name)
    | Fill a -> (
        match ty with
        | Array (n, _) -> Array (n, type_of scope a)
        | _ -> bug "a %s is filled like an array in `%s`" (show scope ty) scope.node.name)
    | Index (a, k) ->
        let n, element = array scope a in
        if k < 0 || k >= n then
          bug "index %d is out of bounds for an array of size %d in `%s`" k n scope.node.name;
        element
    | At { array = a; index; default } ->
        expect scope "an index" Int (type_of scope index);
        expect scope "a default" (snd (array scope a)) (type_of scope default);
        ty
    | Replace { array = a; index; value } ->
        expect scope "an index" Int (type_of scope index);
        expect scope "an element" (snd (array scope a)) (type_of scope value);
        type_of scope a
    | Param k -> (
        match List.nth_opt scope.program.params k with
        | Some { param_ty = (Bool | Int | Float) as ty; _ } -> ty
        | Some _ | None -> bug "there is no parameter %d in `%s`" k scope.node.name)
    | Absent -> (
        match ty with
        | Foreign _ -> ty
        | _ -> bug "a %s, not a foreign type, is absent in `%s`" (show scope ty) scope.node.name)
    | Delay { init; next } ->
        stateful scope "delay";
        lasting scope ty;
        expect scope "a delay's initial value" ty (type_of scope init);
        type_of scope next
    | Time { restart } ->
        stateful scope "time";
        expect scope "the restart condition of a time" Bool (type_of scope restart);
        Float
    | Step_time ->
        stateful scope "a step's time";
        Float
    | Ticks period ->
        stateful scope "ticks";
        expect scope "a period" Float (type_of scope period);
        Bool
    | Integral a ->
        stateful scope "integral";
        expect scope "an integral" Float (type_of scope a);
        Float
    | Derivative a ->
        stateful scope "derivative";
        expect scope "a derivative" Float (type_of scope a);
        Float
  in
  expect scope (Printf.sprintf "the equation of `%s`" eq.defines.name) ty found

let signal_types = List.map (fun (s : Ir.signal) -> s.ty)
let output_type (_, atom) = Operands.ty atom

(* The input and output types of a loop, given the input and output types of its node. *)
let loop scope (i : Ir.instance) (l : Ir.loop) inputs outputs =
  let taken (argument : Ir.argument) (ty : Ir.ty) : Ir.ty =
    match argument with
    | Accumulator | Same -> ty
    | Element -> Array (l.count, ty)
    | Counter ->
        expect scope "a counter" Int ty;
        Int
  in
  let rec given (arguments : Ir.argument list) inputs outputs : Ir.ty list =
    match (arguments, inputs, outputs) with
    | Accumulator :: arguments, input :: inputs, output :: outputs ->
        expect scope "an accumulator" input output;
        output :: given arguments inputs outputs
    | Accumulator :: _, _, _ -> bug "`%s` has no output for an accumulator" i.name
    | arguments, _, _ ->
        if List.mem Ir.Accumulator arguments then
          bug "the accumulators of `%s` do not come first" i.name;
        List.map (fun ty : Ir.ty -> Array (l.count, ty)) outputs
  in
  (List.map2 taken l.arguments inputs, given l.arguments inputs outputs)

let instance scope names (i : Ir.instance) =
  if i.node < 0 || i.node >= scope.index then
    bug "`%s` calls node %d, which does not come before it" scope.node.name i.node;
  if Hashtbl.mem names i.name then bug "`%s` has two instances named `%s`" scope.node.name i.name;
  Hashtbl.add names i.name ();
  let callee = scope.program.nodes.(i.node) in
  if callee.kind = Signal_function then stateful scope "signal function";
  check_all scope "a static" (signal_types callee.statics) i.statics;
  List.iter (lasting scope) (signal_types callee.statics);
  (* Takes the output types from the callee's atoms, because an output may be a constant. *)
  let inputs = signal_types callee.inputs and outputs = List.map output_type callee.outputs in
  let inputs, outputs =
    match i.loop with
    | None -> (inputs, outputs)
    | Some l ->
        if l.count < 1 || List.compare_lengths l.arguments inputs <> 0 then
          bug "the loop `%s` in `%s` has no iterations or the wrong number of arguments" i.name
            scope.node.name;
        loop scope i l inputs outputs
  in
  check_all scope "an input" inputs i.inputs;
  check_all scope "an output" outputs (List.map (fun s -> Ir.Signal s) i.outputs);
  let trial (t : Ir.trial) =
    if List.compare_lengths t.given i.inputs <> 0 then
      bug "a trial of `%s` in `%s` receives the wrong number of inputs" i.name scope.node.name;
    let is_output (s : Ir.signal) = List.exists (fun (o : Ir.signal) -> o.id = s.id) i.outputs in
    if not (List.for_all is_output t.gives) then
      bug "a trial of `%s` in `%s` returns a value that is not an output" i.name scope.node.name
  in
  List.iter trial i.trials

let transition scope (modes : Ir.node array) (t : Ir.transition) =
  if t.target < 0 || t.target >= Array.length modes then
    bug "a transition in `%s` leads to mode %d, which does not exist" scope.node.name t.target;
  expect scope "the condition of a transition" Bool (type_of scope t.occurs);
  check_all scope "a parameter of a mode" (signal_types modes.(t.target).statics) t.arguments;
  List.iter (lasting scope) (signal_types modes.(t.target).statics)

(* [modes_of]: for each preceding node that is a mode, all modes of its machine. *)
let machine scope modes_of (m : Ir.machine) =
  let modes =
    List.map
      (fun mode ->
        if mode < 0 || mode >= scope.index then
          bug "a mode of `%s` does not come before it" scope.node.name;
        if Hashtbl.mem modes_of mode then
          bug "`%s` is a mode of two machines" scope.program.nodes.(mode).name;
        scope.program.nodes.(mode))
      m.modes
  in
  let all = Array.of_list modes in
  List.iter (fun mode -> Hashtbl.replace modes_of mode all) m.modes;
  stateful scope "machine";
  List.iter
    (fun (mode : Ir.node) ->
      check_all scope "an input of a mode" (signal_types mode.inputs) m.inputs;
      check_all scope "an output of a mode"
        (List.map output_type mode.outputs)
        (List.map (fun s -> Ir.Signal s) m.outputs))
    modes;
  Option.iter
    (fun a -> expect scope "the condition for running a machine" Bool (type_of scope a))
    m.active;
  List.iter (transition scope all) m.start;
  List.iter (transition scope all) m.controls;
  match List.rev m.start with
  | { occurs = Bool true; delayed = false; _ } :: _ -> ()
  | _ -> bug "the last start transition of `%s` is conditional or delayed" scope.node.name

(* Checks that a node with a machine has no other state. *)
let only_machine scope =
  let stateful_instance (i : Ir.instance) = scope.program.nodes.(i.node).kind = Signal_function in
  if
    List.exists (fun (eq : Ir.equation) -> Rhs.is_stateful eq.rhs) scope.node.equations
    || List.exists stateful_instance scope.node.instances
    || scope.node.transitions <> []
  then bug "`%s` has a machine and other state" scope.node.name

let foreign scope (f : Ir.foreign) =
  let node = scope.node in
  if
    node.equations <> [] || node.instances <> [] || Option.is_some node.machine
    || node.transitions <> [] || node.statics <> []
  then bug "`%s` is foreign and has a body" node.name;
  if f.import.kind <> node.kind || not (List.mem f.import scope.program.imports) then
    bug "`%s` does not match its import" node.name;
  check_all scope "an argument"
    (List.concat_map Shape.leaves f.import.arguments)
    (List.map (fun s -> Ir.Signal s) node.inputs);
  let results = List.map (fun s -> Ir.Signal s) f.results in
  check_all scope "a result" (Shape.leaves f.import.result) results

let node program owners names modes_of index (node : Ir.node) =
  if Hashtbl.mem names node.name then bug "there are two nodes named `%s`" node.name;
  Hashtbl.add names node.name ();
  let scope = { program; index; node; defined = Hashtbl.create 16 } in
  Signals.iter (define owners scope) node;
  if node.kind = Function && node.statics <> [] then
    bug "the function `%s` has static parameters" node.name;
  List.iter (equation scope) node.equations;
  let instance_names = Hashtbl.create 8 in
  List.iter (instance scope instance_names) node.instances;
  List.iter (fun (_, atom) -> ignore (type_of scope atom)) node.outputs;
  if Option.is_some node.machine then only_machine scope;
  Option.iter (foreign scope) node.foreign;
  Option.iter (machine scope modes_of) node.machine;
  scope

(* Checks transitions separately, because they may lead to modes that come later in the program. *)
let transitions modes_of (index, scope) =
  match (Hashtbl.find_opt modes_of index, scope.node.transitions) with
  | None, [] -> ()
  | None, _ :: _ -> bug "`%s` has transitions but is not a mode" scope.node.name
  | Some modes, transitions -> List.iter (transition scope modes) transitions

let program (p : Ir.program) =
  let owners = Hashtbl.create 256 in
  let names = Hashtbl.create 16 in
  let modes_of = Hashtbl.create 16 in
  let check index n =
    let scope = node p owners names modes_of index n in
    if index = Array.length p.nodes - 1 then (
      if n.statics <> [] then bug "the root `%s` has static parameters" n.name;
      check_all scope "a root input" (Shape.leaves p.input)
        (List.map (fun s -> Ir.Signal s) n.inputs);
      let leaves = List.concat_map Shape.leaves (p.output :: List.map snd p.probes) in
      check_all scope "a root output" leaves (List.map snd n.outputs));
    (index, scope)
  in
  if Array.length p.nodes = 0 then bug "the program has no nodes";
  if Signals.next_id p.nodes > p.next_id then
    bug "the id or group of a signal is not less than `next_id`";
  Array.iter (transitions modes_of) (Array.mapi check p.nodes)
