(* The instance whose machine can move into this node. *)
let candidate (nodes : Ir.node array) uses (node : Ir.node) =
  let is_stateful (e : Ir.equation) = Rhs.is_stateful e.rhs in
  let stateful (i : Ir.instance) = nodes.(i.node).kind = Signal_function in
  if Option.is_some node.machine || node.transitions <> [] || List.exists is_stateful node.equations
  then None
  else
    match List.filter stateful node.instances with
    | [ i ]
      when Option.is_some nodes.(i.node).machine
           && uses.(i.node) = 1
           && i.trials = [] && i.loop = None ->
        Some i
    | [] | _ :: _ -> None

(* The signals of the machine's node keep their ids, because the node has no other user. *)
let take_over (nodes : Ir.node array) (node : Ir.node) (i : Ir.instance) =
  let callee = nodes.(i.node) in
  let substitution = Substitution.create () in
  List.iter2 (Substitution.replace substitution) callee.statics i.statics;
  List.iter2 (Substitution.replace substitution) callee.inputs i.inputs;
  List.iter2
    (fun (s : Ir.signal) (_, atom) -> Substitution.replace substitution s atom)
    i.outputs callee.outputs;
  let others = List.filter (fun (other : Ir.instance) -> other.name <> i.name) node.instances in
  let names = Basis.Names.create () in
  let named (f : Ir.instance) = { f with name = Basis.Names.unique names f.name } in
  let others = List.map named others in
  let inner = List.map named callee.instances in
  nodes.(i.node) <- { callee with outputs = []; equations = []; instances = []; machine = None };
  Substitution.node substitution
    {
      node with
      equations = List.rev_append (List.rev node.equations) callee.equations;
      instances = others @ inner;
      machine = callee.machine;
    }

let program (program : Ir.program) =
  let nodes = Array.copy program.nodes in
  let uses = Inline.uses program in
  let changed = ref false in
  Array.iteri
    (fun index node ->
      match candidate nodes uses node with
      | Some i ->
          nodes.(index) <- take_over nodes node i;
          changed := true
      | None -> ())
    program.nodes;
  if !changed then { program with nodes } else program
