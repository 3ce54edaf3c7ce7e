open Basis

(* A group of loops to join. *)
type group = {
  count : int;
  varies : bool;
      (* whether the group depends on inputs or state. If not, it must not be joined with loops that
         do, because its results may be the initial values of delays *)
  members : (Ir.instance * Ir.loop) list; (* last one first *)
  arrays : Ir.signal list; (* arrays that members define *)
  after : unit Int_table.t; (* signals that depend on outputs of the group *)
}

type work = {
  program : Ir.program;
  varying : unit Int_table.t; (* signals whose values are not known at the start *)
  mutable groups : group list; (* the groups, latest one first; only the latest may grow *)
}

let note table = List.iter (fun (s : Ir.signal) -> Int_table.replace table s.id ())
let any table = List.exists (fun (s : Ir.signal) -> Int_table.mem table s.id)
let accumulators (l : Ir.loop) = List.length (List.filter (fun a -> a = Ir.Accumulator) l.arguments)

(* Whether an argument is the element that another member computes in the same iteration. *)
let is_direct group (argument, (atom : Ir.atom)) =
  match (argument, atom) with
  | Ir.Element, Signal s -> List.exists (fun (array : Ir.signal) -> array.id = s.id) group.arrays
  | _, _ -> false

let varies work (item : Schedule.item) =
  let own =
    match item with
    | Equation e -> Rhs.is_stateful e.rhs
    | Instance i -> work.program.nodes.(i.node).kind = Signal_function
    | Trial _ | Machine _ -> true
  in
  own || any work.varying (Schedule.needs item)

let may_join group ~varies (i : Ir.instance) (l : Ir.loop) =
  let direct, others = List.partition (is_direct group) (List.combine l.arguments i.inputs) in
  group.count = l.count && Bool.equal group.varies varies && direct <> []
  && not (any group.after (Operands.signals (i.statics @ List.map snd others)))

let add_loop work ~varies (i : Ir.instance) (l : Ir.loop) =
  let own = List.filteri (fun k _ -> k >= accumulators l) i.outputs in
  let group, others =
    match work.groups with
    | group :: others when may_join group ~varies i l ->
        ({ group with members = (i, l) :: group.members; arrays = own @ group.arrays }, others)
    | groups ->
        let after = Int_table.create 16 in
        ({ count = l.count; varies; members = [ (i, l) ]; arrays = own; after }, groups)
  in
  note group.after i.outputs;
  work.groups <- group :: others

let add_item work (item : Schedule.item) =
  let varies = varies work item in
  if varies then note work.varying (Schedule.defines item);
  match (item, work.groups) with
  | Instance ({ loop = Some l; trials = []; _ } as i), _ -> add_loop work ~varies i l
  | _, group :: _ when any group.after (Schedule.needs item) ->
      note group.after (Schedule.defines item)
  | _, _ -> ()

let groups_of program (node : Ir.node) =
  let work = { program; varying = Int_table.create 64; groups = [] } in
  note work.varying node.inputs;
  List.iter (add_item work) (Schedule.of_node node);
  List.filter (fun group -> List.compare_length_with group.members 1 > 0) (List.rev work.groups)

(* {1 The node of a joined loop} *)

type context = {
  mutable nodes : Ir.node list; (* the nodes finished so far, in reverse order *)
  mutable done_ : int;
  numbers : int array; (* new indices of the program's nodes *)
  names : Names.t;
  mutable fresh : int;
}

let put context node =
  context.nodes <- node :: context.nodes;
  context.done_ <- context.done_ + 1

let signal context ?(name = "") ty span : Ir.signal =
  let id = context.fresh in
  context.fresh <- id + 1;
  { id; name; ty; group = id; span }

(* An input of the joined loop, and the parameter of its node. *)
type given = { argument : Ir.argument; atom : Ir.atom; parameter : Ir.signal }

type joined = {
  context : context;
  callees : Ir.node array;
  mutable statics : (Ir.atom * Ir.signal) list;
      (* the arguments and parameters so far, last one first *)
  mutable given : given list; (* last one first *)
  mutable results : (bool * Ir.signal * Ir.signal) list;
      (* for each result, last one first: whether it is the final value of an accumulator, the
         signal outside the loop, and the signal inside it *)
  mutable bodies : Ir.instance list; (* last one first *)
  elements : Ir.signal Int_table.t;
      (* for each array that a member defines, the element that the current iteration computes *)
}

let parameter joined (like : Ir.signal) = signal joined.context ~name:like.name like.ty like.span

(* The parameter for an input. Members that read the same array or value share one parameter. *)
let pass joined argument (atom : Ir.atom) (like : Ir.signal) : Ir.atom =
  let same g =
    g.argument = argument
    &&
    match argument with
    | Ir.Element | Same -> (
        match (g.atom, atom) with Ir.Signal a, Ir.Signal b -> a.id = b.id | _, _ -> false)
    | Accumulator | Counter -> false
  in
  match List.find_opt same joined.given with
  | Some g -> Signal g.parameter
  | None ->
      let parameter = parameter joined like in
      joined.given <- { argument; atom; parameter } :: joined.given;
      Signal parameter

let add_member joined ((i : Ir.instance), (l : Ir.loop)) =
  let callee = joined.callees.(i.node) in
  let static atom like =
    let parameter = parameter joined like in
    joined.statics <- (atom, parameter) :: joined.statics;
    Ir.Signal parameter
  in
  let input (argument, (atom : Ir.atom)) like =
    match (argument, atom) with
    | Ir.Element, Signal s when Int_table.mem joined.elements s.id ->
        Ir.Signal (Int_table.find joined.elements s.id)
    | _, _ -> pass joined argument atom like
  in
  let statics = List.map2 static i.statics callee.statics in
  let inputs = List.map2 input (List.combine l.arguments i.inputs) callee.inputs in
  let accumulated = accumulators l in
  let output k (s : Ir.signal) (_, atom) =
    let inside = signal joined.context ~name:s.name (Operands.ty atom) s.span in
    if k >= accumulated then Int_table.replace joined.elements s.id inside;
    joined.results <- (k < accumulated, s, inside) :: joined.results;
    inside
  in
  let outputs = List.mapi (fun k (s, o) -> output k s o) (List.combine i.outputs callee.outputs) in
  let node = joined.context.numbers.(i.node) in
  joined.bodies <- { i with node; statics; inputs; outputs; loop = None } :: joined.bodies

let join context (program : Ir.program) (caller : Ir.node) group : Ir.instance =
  let members = List.rev group.members in
  let joined =
    {
      context;
      callees = program.nodes;
      statics = [];
      given = [];
      results = [];
      bodies = [];
      elements = Int_table.create 16;
    }
  in
  List.iter (add_member joined) members;
  let accumulators, others =
    List.partition (fun g -> g.argument = Ir.Accumulator) (List.rev joined.given)
  in
  let given = accumulators @ others in
  let at_end, arrays = List.partition (fun (last, _, _) -> last) (List.rev joined.results) in
  let results = at_end @ arrays in
  let is_stateful ((i : Ir.instance), _) = program.nodes.(i.node).kind = Signal_function in
  let first, _ = List.hd members in
  let named, _ = Option.value (List.find_opt is_stateful members) ~default:(List.hd members) in
  let output k (_, _, inside) = (Printf.sprintf "out.%d" (k + 1), Ir.Signal inside) in
  put context
    {
      name = Names.unique context.names (caller.name ^ ".loop");
      origin = caller.origin;
      kind = (if List.exists is_stateful members then Signal_function else Function);
      statics = List.rev_map snd joined.statics;
      inputs = List.map (fun g -> g.parameter) given;
      outputs = List.mapi output results;
      equations = [];
      instances = List.rev joined.bodies;
      machine = None;
      foreign = None;
      transitions = [];
      span = first.span;
      file = caller.file;
    };
  {
    node = context.done_ - 1;
    name = named.name;
    statics = List.rev_map fst joined.statics;
    inputs = List.map (fun g -> g.atom) given;
    outputs = List.map (fun (_, s, _) -> s) results;
    loop = Some { count = group.count; arguments = List.map (fun g -> g.argument) given };
    trials = [];
    span = first.span;
  }

(* {1 Programs} *)

let has_loops (node : Ir.node) =
  let is_loop (i : Ir.instance) = Option.is_some i.loop in
  List.compare_length_with (List.filter is_loop node.instances) 1 > 0

let renumber context (node : Ir.node) =
  let number k = context.numbers.(k) in
  {
    node with
    instances =
      Long_list.map (fun (i : Ir.instance) -> { i with node = number i.node }) node.instances;
    machine =
      Option.map (fun (m : Ir.machine) -> { m with modes = List.map number m.modes }) node.machine;
  }

let add context (program : Ir.program) index (node : Ir.node) groups =
  let joined = Hashtbl.create 16 in
  let loops = List.map (join context program node) groups in
  List.iter
    (fun group ->
      List.iter (fun ((i : Ir.instance), _) -> Hashtbl.replace joined i.name ()) group.members)
    groups;
  let kept =
    List.filter (fun (i : Ir.instance) -> not (Hashtbl.mem joined i.name)) node.instances
  in
  let others = renumber context { node with instances = kept } in
  context.numbers.(index) <- context.done_;
  put context { others with instances = List.rev_append (List.rev loops) others.instances }

let program (program : Ir.program) =
  let groups (node : Ir.node) =
    if has_loops node && Schedule.loops node = [] then groups_of program node else []
  in
  let groups = Array.map groups program.nodes in
  if Array.for_all (fun groups -> groups = []) groups then program
  else
    let context =
      {
        nodes = [];
        done_ = 0;
        numbers = Array.make (Array.length program.nodes) 0;
        names = Names.create ();
        fresh = program.next_id;
      }
    in
    let take (node : Ir.node) = ignore (Names.unique context.names node.name : string) in
    Array.iter take program.nodes;
    Array.iteri (fun k node -> add context program k node groups.(k)) program.nodes;
    { program with nodes = Array.of_list (List.rev context.nodes); next_id = context.fresh }
