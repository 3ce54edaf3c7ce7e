open Basis

(* Maximum size of a node that is always inlined: about as much code as fits on a few lines. *)
let small = 8

(* A call counts as several operations, because it hides more than one. *)
let size_of_instance = 4

(* Maximum size of a node that is inlined if it is called only once. *)
let small_once = 16

let size (node : Ir.node) =
  let operation (e : Ir.equation) =
    match e.rhs with Copy _ | Construct { payload = []; _ } -> 0 | _ -> 1
  in
  List.fold_left
    (fun size e -> size + operation e)
    (size_of_instance * List.length node.instances)
    node.equations

let uses (program : Ir.program) =
  let uses = Array.make (Array.length program.nodes) 0 in
  let use (i : Ir.instance) = uses.(i.node) <- uses.(i.node) + 1 in
  Array.iter (fun (node : Ir.node) -> List.iter use node.instances) program.nodes;
  uses

type context = {
  nodes : Ir.node array;  (** callees, already processed *)
  is_small : bool array;  (** for each node processed so far, whether it is inlined *)
  passages : Dependency.passage array Lazy.t;
      (** computed for the original program, because inlining does not change which outputs depend
          on which inputs. Needed only for dependency cycles *)
  mutable fresh : int;
}

let unique names ~prefix name =
  Names.unique names (if Names.mem names name then prefix ^ "." ^ name else name)

let names_of iter =
  let names = Names.create () in
  let take name = ignore (Names.unique names name : string) in
  iter (fun name -> if name <> "" && not (Names.mem names name) then take name);
  names

(* The equations and instances that replace [instance]. *)
let expand context ~signals ~instances (instance : Ir.instance) =
  let callee = context.nodes.(instance.node) in
  let copies : Ir.atom Int_table.t = Int_table.create 32 in
  let groups = Int_table.create 8 in
  let bind (s : Ir.signal) atom = Int_table.replace copies s.id atom in
  List.iter2 bind callee.statics instance.statics;
  List.iter2 bind callee.inputs instance.inputs;
  (* An output that has a name in the caller keeps that name. *)
  List.iter2
    (fun (s : Ir.signal) (_, a) ->
      match (a : Ir.atom) with
      | Signal inner when s.name <> "" && not (Int_table.mem copies inner.id) ->
          bind inner (Signal s)
      | Signal _ | Bool _ | Int _ | Float _ -> ())
    instance.outputs callee.outputs;
  let fresh_id () =
    let id = context.fresh in
    context.fresh <- id + 1;
    id
  in
  let copy (s : Ir.signal) =
    match Int_table.find_opt copies s.id with
    | Some (Signal copy) -> copy
    | Some (Bool _ | Int _ | Float _) ->
        Diagnostic.bug ~stage:"Flow.Inline" "`%s` contains an equation for one of its parameters"
          callee.name
    | None ->
        let id = fresh_id () in
        let group =
          match Int_table.find_opt groups s.group with
          | Some group -> group
          | None ->
              Int_table.replace groups s.group id;
              id
        in
        let name = if s.name = "" then "" else unique signals ~prefix:instance.name s.name in
        let copy = { s with id; group; name } in
        bind s (Signal copy);
        copy
  in
  let atom : Ir.atom -> Ir.atom = function
    | Signal s -> (
        match Int_table.find_opt copies s.id with Some atom -> atom | None -> Signal (copy s))
    | (Bool _ | Int _ | Float _) as constant -> constant
  in
  let equations =
    Long_list.map
      (fun (e : Ir.equation) ->
        let defines = copy e.defines in
        { e with defines; rhs = Operands.map atom e.rhs })
      callee.equations
  in
  let inner =
    Long_list.map
      (fun (i : Ir.instance) ->
        let name = unique instances ~prefix:instance.name i.name in
        { (Operands.of_instance atom copy i) with name })
      callee.instances
  in
  let results =
    List.fold_left2
      (fun results (s : Ir.signal) (_, a) ->
        match atom a with
        | Signal same when same.id = s.id -> results
        | by -> { Ir.defines = s; rhs = Copy by; span = instance.span } :: results)
      [] instance.outputs callee.outputs
  in
  (List.rev_append (List.rev equations) (List.rev results), inner)

(* Removes copies, which would accumulate when nodes are inlined into each other repeatedly. *)
let without_copies (node : Ir.node) =
  let substitution = Substitution.create () in
  List.iter
    (fun (e : Ir.equation) ->
      match e.rhs with Copy a -> Substitution.replace substitution e.defines a | _ -> ())
    node.equations;
  Substitution.node substitution node

(* Inlines the instances that satisfy [chosen], each in its place. *)
let expand_chosen context chosen (node : Ir.node) =
  let signals = names_of (fun f -> Signals.iter (fun (s : Ir.signal) -> f s.name) node) in
  let instances =
    names_of (fun f -> List.iter (fun (i : Ir.instance) -> f i.name) node.instances)
  in
  let equations, kept =
    List.fold_left
      (fun (equations, kept) item ->
        match item with
        | Schedule.Machine _ | Trial _ -> (equations, kept)
        | Equation e -> (e :: equations, kept)
        | Instance i when not (chosen i) -> (equations, i :: kept)
        | Instance i ->
            let inner_equations, inner_instances = expand context ~signals ~instances i in
            (List.rev_append inner_equations equations, List.rev_append inner_instances kept))
      ([], []) (Schedule.in_source_order node)
  in
  without_copies { node with equations = List.rev equations; instances = List.rev kept }

(* Whether each output needs every input. If so, inlining the instance cannot break a cycle. *)
let is_one_operation context (i : Ir.instance) =
  let inputs = List.length i.inputs in
  Option.is_some i.loop
  || Array.for_all
       (fun passed -> Dependency.Inputs.cardinal passed = inputs)
       (Lazy.force context.passages).(i.node).passed

(* Groups the outputs by the inputs that they need. Each group that does not need all the inputs
   gets a trial step. *)
let with_trials context (i : Ir.instance) =
  let { Dependency.passed; _ } = (Lazy.force context.passages).(i.node) in
  let all = List.length i.inputs in
  let add (groups, k) output =
    let needs = passed.(k) in
    let same (other, _) = Dependency.Inputs.equal needs other in
    let groups =
      if Dependency.Inputs.cardinal needs = all then groups
      else
        match List.partition same groups with
        | [ (_, outputs) ], others -> (needs, output :: outputs) :: others
        | _, _ -> (needs, [ output ]) :: groups
    in
    (groups, k + 1)
  in
  let groups, _ = List.fold_left add ([], 0) i.outputs in
  let trial (needs, outputs) =
    let given j input = if Dependency.Inputs.mem j needs then Some input else None in
    { Ir.gives = List.rev outputs; given = List.mapi given i.inputs }
  in
  { i with trials = List.rev_map trial groups }

let is_machine context (i : Ir.instance) = Option.is_some context.nodes.(i.node).machine

let rec open_loops context (node : Ir.node) =
  match Schedule.loops node with
  | [] -> node
  | loops ->
      let names = String_table.create 16 in
      List.iter
        (List.iter (fun (i : Ir.instance) ->
             if i.trials = [] && not (is_one_operation context i) then
               String_table.replace names i.name ()))
        loops;
      if String_table.length names = 0 then
        Diagnostic.bug ~stage:"Flow.Inline" "`%s` is not causal" node.name;
      let is_chosen (i : Ir.instance) = String_table.mem names i.name in
      let try_machine i =
        if is_chosen i && is_machine context i then with_trials context i else i
      in
      { node with instances = Long_list.map try_machine node.instances }
      |> expand_chosen context (fun i -> is_chosen i && not (is_machine context i))
      |> open_loops context

(* Inlines nodes that satisfy [is_small], from callees to callers, and applies [also] to each
   resulting node. *)
let expand_all ?(also = fun _ node -> node) ~is_small (program : Ir.program) =
  let count = Array.length program.nodes in
  let context =
    {
      nodes = Array.copy program.nodes;
      is_small = Array.make count false;
      passages = lazy (Dependency.program program);
      fresh = program.next_id;
    }
  in
  let chosen (i : Ir.instance) = i.loop = None && i.trials = [] && context.is_small.(i.node) in
  for k = 0 to count - 1 do
    let node = program.nodes.(k) in
    let is_changed = List.exists chosen node.instances in
    let expanded = also context (if is_changed then expand_chosen context chosen node else node) in
    context.nodes.(k) <- expanded;
    context.is_small.(k) <-
      Option.is_none expanded.machine && Option.is_none expanded.foreign && is_small k expanded
  done;
  if Array.for_all2 ( == ) context.nodes program.nodes then program
  else { program with nodes = context.nodes; next_id = context.fresh }

let to_look_at ~most program =
  let is_small _ (node : Ir.node) = List.compare_length_with node.equations most <= 0 in
  expand_all ~is_small program

let program program =
  let uses = uses program in
  let is_small k node = size node <= if uses.(k) = 1 then small_once else small in
  let also context (node : Ir.node) =
    if node.instances = [] then node else open_loops context node
  in
  expand_all ~also ~is_small program
