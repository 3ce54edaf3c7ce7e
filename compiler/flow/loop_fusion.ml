open Basis
module Groups = Set.Make (Int)

(* Loops to be joined. *)
type group = {
  count : int;
  varies : bool;  (* what is known at the start stays so: delays may start from it *)
  mutable members : (Ir.instance * Ir.loop) list;  (* last first *)
  mutable needs : Groups.t;  (* groups that something before it comes from *)
  elements : (int, unit) Hashtbl.t;  (* signals whose elements are given to members *)
  arrays : (int, unit) Hashtbl.t;  (* arrays that members define *)
}

type work = {
  program : Ir.program;
  varying : (int, unit) Hashtbl.t;  (* signals that are not known at the start *)
  mutable groups : group array;
  origin : (int, Groups.t) Hashtbl.t;  (* of a signal: groups that it comes from *)
  first_of : (int, Ir.signal) Hashtbl.t;  (* of a number: the array whose element 0 it is *)
}

(* Elements 0 of arrays. *)
let firsts (node : Ir.node) =
  let firsts = Hashtbl.create 8 in
  List.iter
    (fun (e : Ir.equation) ->
      match (e.rhs, e.defines.ty) with
      | Index (Signal array, 0), (Bool | Int | Float) -> Hashtbl.replace firsts e.defines.id array
      | _, _ -> ())
    node.equations;
  firsts

let first_of firsts (atom : Ir.atom) =
  match atom with Signal s -> Hashtbl.find_opt firsts s.id | Bool _ | Int _ | Float _ -> None

let origin work (atom : Ir.atom) =
  match atom with
  | Signal s -> Option.value (Hashtbl.find_opt work.origin s.id) ~default:Groups.empty
  | Bool _ | Int _ | Float _ -> Groups.empty

let origins work = List.fold_left (fun all atom -> Groups.union all (origin work atom)) Groups.empty

(* Also what the groups themselves come from. *)
let closure work groups =
  let rec visit g seen =
    if Groups.mem g seen then seen
    else Groups.fold visit work.groups.(g).needs (Groups.add g seen)
  in
  Groups.fold visit groups Groups.empty

let accumulators (l : Ir.loop) =
  List.length (List.filter (fun a -> a = Ir.Accumulator) l.arguments)

let arrays (i : Ir.instance) (l : Ir.loop) =
  List.filteri (fun k _ -> k >= accumulators l) i.outputs

let operands (i : Ir.instance) (l : Ir.loop) =
  List.rev_append
    (List.rev_map (fun atom -> (Ir.Same, atom)) i.statics)
    (List.combine l.arguments i.inputs)

(* A fold that starts at the first element finds it in its first round. *)
let is_direct work group (argument, (atom : Ir.atom)) =
  match (argument, atom) with
  | Ir.Element, Signal s -> Hashtbl.mem group.arrays s.id
  | Accumulator, atom -> (
      match first_of work.first_of atom with
      | Some array -> Hashtbl.mem group.arrays array.id
      | None -> false)
  | _, _ -> false

let shares group (argument, (atom : Ir.atom)) =
  match (argument, atom) with
  | Ir.Element, Signal s -> Hashtbl.mem group.arrays s.id || Hashtbl.mem group.elements s.id
  | _, _ -> false

let indirect work group operands =
  List.filter_map
    (fun operand -> if is_direct work group operand then None else Some (snd operand))
    operands

let varies work (item : Schedule.item) =
  let own =
    match item with
    | Equation e -> Rhs.is_stateful e.rhs
    | Instance i -> work.program.nodes.(i.node).kind = Signal_function
    | Trial _ | Machine _ -> true
  in
  own || List.exists (fun (s : Ir.signal) -> Hashtbl.mem work.varying s.id) (Schedule.needs item)

let may_join work g ~varies (l : Ir.loop) operands =
  let group = work.groups.(g) in
  group.count = l.count
  && Bool.equal group.varies varies
  && List.exists (shares group) operands
  && not (Groups.mem g (closure work (origins work (indirect work group operands))))

(* Joins are looked for among so many groups, the latest. *)
let most_tried = 8

let add_loop work ~varies (i : Ir.instance) (l : Ir.loop) =
  let operands = operands i l in
  let count = Array.length work.groups in
  let rec find g =
    if g < 0 || g < count - most_tried then None
    else if may_join work g ~varies l operands then Some g
    else find (g - 1)
  in
  let g =
    match find (count - 1) with
    | Some g -> g
    | None ->
        let group =
          {
            count = l.count;
            varies;
            members = [];
            needs = Groups.empty;
            elements = Hashtbl.create 8;
            arrays = Hashtbl.create 8;
          }
        in
        work.groups <- Array.append work.groups [| group |];
        count
  in
  let group = work.groups.(g) in
  group.needs <- Groups.union group.needs (origins work (indirect work group operands));
  group.members <- (i, l) :: group.members;
  List.iter
    (fun (argument, (atom : Ir.atom)) ->
      match (argument, atom) with
      | Ir.Element, Signal s -> Hashtbl.replace group.elements s.id ()
      | _, _ -> ())
    operands;
  List.iter (fun (s : Ir.signal) -> Hashtbl.replace group.arrays s.id ()) (arrays i l);
  List.iter
    (fun (s : Ir.signal) -> Hashtbl.replace work.origin s.id (Groups.singleton g))
    i.outputs

let add_item work (item : Schedule.item) =
  let varies = varies work item in
  if varies then
    List.iter (fun (s : Ir.signal) -> Hashtbl.replace work.varying s.id ()) (Schedule.defines item);
  match item with
  | Instance ({ loop = Some l; trials = []; _ } as i) -> add_loop work ~varies i l
  | Equation _ | Instance _ | Trial _ | Machine _ ->
      let from = origins work (List.map (fun s -> Ir.Signal s) (Schedule.needs item)) in
      if not (Groups.is_empty from) then
        List.iter
          (fun (s : Ir.signal) -> Hashtbl.replace work.origin s.id from)
          (Schedule.defines item)

let groups_of program (node : Ir.node) =
  let work =
    {
      program;
      varying = Hashtbl.create 64;
      groups = [||];
      origin = Hashtbl.create 64;
      first_of = firsts node;
    }
  in
  List.iter (fun (s : Ir.signal) -> Hashtbl.replace work.varying s.id ()) node.inputs;
  List.iter (add_item work) (Schedule.of_node node);
  List.filter (fun group -> List.length group.members > 1) (Array.to_list work.groups)

(* The least or largest number may as well start from NaN as from the first element. *)
let is_extreme (node : Ir.node) =
  match (node.inputs, node.outputs) with
  | [ best; x ], [ (_, best') ] -> (
      match Extreme.find node ~best best' with
      | Some (_, element) -> element.id = x.id
      | None -> false)
  | _, _ -> false

(* {1 The node of a joined loop} *)

type context = {
  mutable nodes : Ir.node list;  (* done, last first *)
  mutable done_ : int;
  numbers : int array;  (* of the nodes of the program, where they are now *)
  names : (string, unit) Hashtbl.t;
  mutable fresh : int;
}

let put context node =
  context.nodes <- node :: context.nodes;
  context.done_ <- context.done_ + 1

let signal context ?(name = "") ty span : Ir.signal =
  let id = context.fresh in
  context.fresh <- id + 1;
  { id; name; ty; group = id; span }

let rec unused names ?(n = 1) base =
  let name = if n = 1 then base else Printf.sprintf "%s_%d" base n in
  if Hashtbl.mem names name then unused names ~n:(n + 1) base
  else begin
    Hashtbl.replace names name ();
    name
  end

let atom_type (atom : Ir.atom) : Ir.ty =
  match atom with Signal s -> s.ty | Bool _ -> Bool | Int _ -> Int | Float _ -> Float

(* What the joined loop is given: a parameter of its node for each. *)
type given = { argument : Ir.argument; atom : Ir.atom; parameter : Ir.signal }

let join context (program : Ir.program) (caller : Ir.node) group : Ir.instance =
  let members = List.rev group.members in
  let statics = ref [] and given = ref [] and results = ref [] and bodies = ref [] in
  let firsts = firsts caller and equations = ref [] in
  (* Inside: the element of an array that a member defines. *)
  let elements = Hashtbl.create 16 in
  let pass argument (atom : Ir.atom) (like : Ir.signal) : Ir.atom =
    let same g =
      g.argument = argument
      && match argument with
         | Ir.Element | Same -> (
             match (g.atom, atom) with Ir.Signal a, Ir.Signal b -> a.id = b.id | _, _ -> false)
         | Accumulator | Counter -> false
    in
    match List.find_opt same !given with
    | Some g -> Signal g.parameter
    | None ->
        let parameter = signal context ~name:like.name like.ty like.span in
        given := { argument; atom; parameter } :: !given;
        Signal parameter
  in
  let define ty span rhs : Ir.atom =
    let defines = signal context ty span in
    equations := { Ir.defines; rhs; span } :: !equations;
    Signal defines
  in
  let is_first_round =
    lazy
      (let parameter = signal context ~name:"i" Int caller.span in
       given := { argument = Counter; atom = Int 0l; parameter } :: !given;
       define Bool caller.span (Op (Equal, [ Signal parameter; Int 0l ])))
  in
  (* An accumulator that starts as an element of the first round. *)
  let from_first ~extreme element (like : Ir.signal) =
    if extreme && like.ty = Float then pass Accumulator (Float Fold.nan) like
    else
      let zero : Ir.atom = match like.ty with Bool -> Bool false | Int -> Int 0l | _ -> Float 0. in
      let else_ = pass Accumulator zero like in
      let condition = Lazy.force is_first_round in
      define like.ty like.span (If { condition; then_ = Signal element; else_ })
  in
  let add ((i : Ir.instance), (l : Ir.loop)) =
    let callee = program.nodes.(i.node) in
    let static atom (like : Ir.signal) =
      let parameter = signal context ~name:like.name like.ty like.span in
      statics := (atom, parameter) :: !statics;
      Ir.Signal parameter
    in
    let input argument (atom : Ir.atom) like =
      match (argument, atom) with
      | Ir.Element, Signal s when Hashtbl.mem elements s.id ->
          Ir.Signal (Hashtbl.find elements s.id)
      | Accumulator, _ -> (
          match
            Option.bind (first_of firsts atom) (fun (array : Ir.signal) ->
                Hashtbl.find_opt elements array.id)
          with
          | Some element -> from_first ~extreme:(is_extreme callee) element like
          | None -> pass argument atom like)
      | _, _ -> pass argument atom like
    in
    let own_statics = List.map2 static i.statics callee.statics in
    let rec inputs arguments atoms parameters =
      match (arguments, atoms, parameters) with
      | argument :: arguments, atom :: atoms, like :: parameters ->
          let first = input argument atom like in
          first :: inputs arguments atoms parameters
      | _, _, _ -> []
    in
    let own_inputs = inputs l.arguments i.inputs callee.inputs in
    let accumulated = accumulators l in
    let output k (s : Ir.signal) (_, atom) =
      let inside = signal context ~name:s.name (atom_type atom) s.span in
      if k >= accumulated then Hashtbl.replace elements s.id inside;
      results := (k < accumulated, s, inside) :: !results;
      inside
    in
    let outputs =
      List.mapi (fun k (s, o) -> output k s o) (List.combine i.outputs callee.outputs)
    in
    bodies :=
      {
        i with
        node = context.numbers.(i.node);
        statics = own_statics;
        inputs = own_inputs;
        outputs;
        loop = None;
      }
      :: !bodies
  in
  List.iter add members;
  let accumulators, others =
    List.partition (fun g -> g.argument = Ir.Accumulator) (List.rev !given)
  in
  let given = accumulators @ others in
  let at_end, arrays = List.partition (fun (last, _, _) -> last) (List.rev !results) in
  let results = at_end @ arrays in
  let is_stateful ((i : Ir.instance), _) = program.nodes.(i.node).kind = Signal_function in
  let first, _ = List.hd members in
  let named, _ = Option.value (List.find_opt is_stateful members) ~default:(List.hd members) in
  let output k (_, _, inside) = (Printf.sprintf "out.%d" (k + 1), Ir.Signal inside) in
  put context
    {
      name = unused context.names (caller.name ^ ".loop");
      origin = caller.origin;
      kind = (if List.exists is_stateful members then Signal_function else Function);
      statics = List.rev_map snd !statics;
      inputs = List.map (fun g -> g.parameter) given;
      outputs = List.mapi output results;
      equations = List.rev !equations;
      instances = List.rev !bodies;
      machine = None;
      foreign = None;
      transitions = [];
      span = first.span;
      file = caller.file;
    };
  {
    node = context.done_ - 1;
    name = named.name;
    statics = List.rev_map fst !statics;
    inputs = List.map (fun g -> g.atom) given;
    outputs = List.map (fun (_, s, _) -> s) results;
    loop = Some { count = group.count; arguments = List.map (fun g -> g.argument) given };
    trials = [];
    span = first.span;
  }

(* {1 Programs} *)

let has_loops (node : Ir.node) =
  List.compare_length_with (List.filter (fun (i : Ir.instance) -> Option.is_some i.loop) node.instances) 1
  > 0

let renumber context (node : Ir.node) =
  let number k = context.numbers.(k) in
  {
    node with
    instances = Long_list.map (fun (i : Ir.instance) -> { i with node = number i.node }) node.instances;
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
  else begin
    let context =
      {
        nodes = [];
        done_ = 0;
        numbers = Array.make (Array.length program.nodes) 0;
        names = Hashtbl.create 64;
        fresh = program.next_id;
      }
    in
    Array.iter (fun (node : Ir.node) -> Hashtbl.replace context.names node.name ()) program.nodes;
    Array.iteri (fun k node -> add context program k node groups.(k)) program.nodes;
    { program with nodes = Array.of_list (List.rev context.nodes); next_id = context.fresh }
  end
