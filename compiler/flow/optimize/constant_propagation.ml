(* The arguments for a parameter in the calls visited so far. *)
type passed = Nothing | Always of Ir.atom  (** all of them are the same literal *) | Different

let of_atom : Ir.atom -> passed = function
  | Signal _ -> Different
  | (Bool _ | Int _ | Float _) as literal -> Always literal

(* The join. Returns the first argument itself if the second adds nothing to it. *)
let join passed other =
  match (passed, other) with
  | _, Nothing | Different, (Always _ | Different) -> passed
  | Nothing, (Always _ | Different) -> other
  | Always a, Always b -> if Operands.same a b then passed else Different
  | Always _, Different -> Different

(* Nodes pass parameters on to each other; modes even do so in cycles. A parameter is constant if
   only one literal ever reaches it. *)
let parameters (program : Ir.program) =
  let nothing node = Array.map (fun _ -> Nothing) (Passed.parameters node) in
  let passed = Array.map nothing program.nodes and place = Passed.places program in
  let root = Array.length passed - 1 in
  passed.(root) <- Array.map (fun _ -> Different) passed.(root);
  let given atom = match place atom with Some (k, j) -> passed.(k).(j) | None -> of_atom atom in
  let note { Passed.callee; arguments } =
    let before = passed.(callee) in
    let joined j (how, atom) = join before.(j) (if how = Ir.Same then given atom else Different) in
    passed.(callee) <- Array.mapi joined arguments;
    not (Array.for_all2 ( == ) before passed.(callee))
  in
  Passed.settle program note;
  Passed.replaced program (fun k j ->
      match passed.(k).(j) with Always literal -> Some literal | Nothing | Different -> None)

let replace substitution s = function
  | Always literal -> Substitution.replace substitution s literal
  | Nothing | Different -> ()

let results (node : Ir.node) = List.map (fun (_, atom) -> of_atom atom) node.outputs

(* An output of a machine is constant if it is the same literal in all modes. *)
let of_modes (nodes : Ir.node array) (machine : Ir.machine) =
  match List.map (fun mode -> results nodes.(mode)) machine.modes with
  | [] -> []
  | first :: others -> List.fold_left (List.map2 join) first others

let outputs (program : Ir.program) =
  let nodes = Array.copy program.nodes in
  let node index (node : Ir.node) =
    let substitution = Substitution.create () in
    let replace = List.iter2 (replace substitution) in
    let instance (i : Ir.instance) =
      if i.loop = None then replace i.outputs (results nodes.(i.node))
    in
    List.iter instance node.instances;
    Option.iter (fun (m : Ir.machine) -> replace m.outputs (of_modes nodes m)) node.machine;
    nodes.(index) <- Substitution.node substitution node
  in
  Array.iteri node program.nodes;
  { program with nodes }

let program program = outputs (parameters program)
