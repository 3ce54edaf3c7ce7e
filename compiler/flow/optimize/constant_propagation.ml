(* What the instances seen so far pass for a parameter. *)
type passed =
  | Nothing
  | Always of Ir.atom  (** the same literal *)
  | Different

let join passed (a : Ir.atom) =
  match (passed, a) with
  | (Nothing | Always _ | Different), Signal _ | Different, (Bool _ | Int _ | Float _) -> Different
  | Nothing, (Bool _ | Int _ | Float _) -> Always a
  | Always b, (Bool _ | Int _ | Float _) -> if Operands.same a b then passed else Different

(* What is passed for a parameter, seen from a mode whose own parameters get
   [own]. *)
let join_in_mode (mode : Ir.node) own passed (a : Ir.atom) =
  let rec parameter j = function
    | (s : Ir.signal) :: others -> (
        match a with
        | Signal read when read.id = s.id -> Some own.(j)
        | Signal _ | Bool _ | Int _ | Float _ -> parameter (j + 1) others)
    | [] -> None
  in
  match parameter 0 mode.statics with
  | Some Nothing -> passed
  | Some (Always literal) -> join passed literal
  | Some Different | None -> join passed a

(* Modes hand parameters to each other in circles: a literal is a literal if
   nothing else ever comes in. Repeats until nothing changes. *)
let parameters_of_modes (nodes : Ir.node array) passed (machine : Ir.machine) =
  let modes = Array.of_list machine.modes in
  let changed = ref true in
  let note join (t : Ir.transition) =
    let into = passed.(modes.(t.target)) in
    List.iteri
      (fun j a ->
        let joined = join into.(j) a in
        if joined != into.(j) then (
          into.(j) <- joined;
          changed := true))
      t.arguments
  in
  let inputs = List.length machine.inputs in
  Array.iter
    (fun mode ->
      let first = Array.length passed.(mode) - inputs in
      List.iteri (fun j a -> passed.(mode).(first + j) <- join Nothing a) machine.inputs)
    modes;
  while !changed do
    changed := false;
    List.iter (note join) machine.start;
    List.iter (note join) machine.controls;
    Array.iter
      (fun mode ->
        List.iter (note (join_in_mode nodes.(mode) passed.(mode))) nodes.(mode).transitions)
      modes
  done

(* Callers come before callees here, so a literal may go down many levels. *)
let parameters (program : Ir.program) =
  let nodes = Array.copy program.nodes in
  let passed =
    Array.map
      (fun (node : Ir.node) ->
        Array.make (List.length node.statics + List.length node.inputs) Nothing)
      nodes
  in
  for index = Array.length nodes - 1 downto 0 do
    let node = nodes.(index) in
    let substitution = Substitution.create () in
    List.iteri
      (fun j s ->
        match passed.(index).(j) with
        | Always literal -> Substitution.replace substitution s literal
        | Nothing | Different -> ())
      (List.rev_append (List.rev node.statics) node.inputs);
    let node = Substitution.node substitution node in
    nodes.(index) <- node;
    List.iter
      (fun (i : Ir.instance) ->
        let note j join = passed.(i.node).(j) <- join passed.(i.node).(j) in
        List.iteri (fun j a -> note j (fun before -> join before a)) i.statics;
        let first = List.length i.statics in
        let input j (argument : Ir.argument) a =
          note (first + j) (fun before ->
              match argument with
              | Same -> join before a
              | Accumulator | Element | Counter -> Different)
        in
        match i.loop with
        | None -> List.iteri (fun j a -> input j Same a) i.inputs
        | Some l ->
            List.combine l.arguments i.inputs |> List.iteri (fun j (how, a) -> input j how a))
      node.instances;
    Option.iter (parameters_of_modes nodes passed) node.machine
  done;
  { program with nodes }

(* What all modes put out alike is a literal. *)
let outputs_of_modes (nodes : Ir.node array) substitution (machine : Ir.machine) =
  let of_modes = List.map (fun mode -> List.map snd nodes.(mode).outputs) machine.modes in
  let rec each (outputs : Ir.signal list) rests =
    match outputs with
    | [] -> ()
    | s :: others ->
        (match List.fold_left join Nothing (List.map List.hd rests) with
        | Always literal -> Substitution.replace substitution s literal
        | Nothing | Different -> ());
        each others (List.map List.tl rests)
  in
  each machine.outputs of_modes

let outputs (program : Ir.program) =
  let nodes = Array.copy program.nodes in
  Array.iteri
    (fun index (node : Ir.node) ->
      let substitution = Substitution.create () in
      let output s (_, (a : Ir.atom)) =
        match a with
        | Signal _ -> ()
        | Bool _ | Int _ | Float _ -> Substitution.replace substitution s a
      in
      let outputs (i : Ir.instance) =
        if i.loop = None then List.iter2 output i.outputs nodes.(i.node).outputs
      in
      List.iter outputs node.instances;
      Option.iter (outputs_of_modes nodes substitution) node.machine;
      nodes.(index) <- Substitution.node substitution node)
    nodes;
  { program with nodes }

let program program = outputs (parameters program)
