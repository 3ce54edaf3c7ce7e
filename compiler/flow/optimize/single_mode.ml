open Basis

(* Whether the mode has no state and is never left. *)
let is_end (nodes : Ir.node array) mode =
  let node = nodes.(mode) in
  let is_function (i : Ir.instance) = nodes.(i.node).kind = Function in
  node.transitions = [] && Option.is_none node.machine
  && List.for_all is_function node.instances
  && not (List.exists (fun (e : Ir.equation) -> Rhs.is_stateful e.rhs) node.equations)

type sole = {
  mode : int;
  arguments : Ir.atom list;
  ends : (Ir.transition * int) list;  (** transitions of the mode, each with the node it leads to *)
}

let sole (nodes : Ir.node array) (m : Ir.machine) =
  match (m.start, m.controls, m.active) with
  | [ { occurs = Bool true; target; arguments; _ } ], [], None ->
      let modes = Array.of_list m.modes in
      let mode = modes.(target) in
      let to_ (t : Ir.transition) = (t, modes.(t.target)) in
      let ends = List.map to_ nodes.(mode).transitions in
      let is_over ((t : Ir.transition), node) = (not t.delayed) && is_end nodes node in
      if List.for_all is_over ends then Some { mode; arguments; ends } else None
  | _, _, _ -> None

(* For each output, its value if it is the same Bool literal in all these nodes. *)
let told (nodes : Ir.node array) ends =
  let bools (_, node) =
    let bool (_, (a : Ir.atom)) = match a with Bool b -> Some b | _ -> None in
    List.map bool nodes.(node).outputs
  in
  match List.map bools ends with
  | [] -> []
  | first :: others ->
      List.fold_left (List.map2 (fun a b -> if a = b then a else None)) first others

(* Whether the mode that runs the instance is left when the instance has these outputs. *)
let is_left_too told (user : Ir.node) (i : Ir.instance) =
  let known = List.map2 (fun s -> Option.map (fun b -> (s, b))) i.outputs told in
  let truth = Truth.at_an_instant user (List.filter_map Fun.id known) in
  i.loop = None && i.trials = []
  && List.exists
       (fun (t : Ir.transition) -> (not t.delayed) && Truth.value truth t.occurs = Some true)
       user.transitions

let is_left_by_all (program : Ir.program) index told =
  let users = ref 0 in
  let by_user (user : Ir.node) =
    List.for_all
      (fun (i : Ir.instance) ->
        i.node <> index
        ||
        (incr users;
         is_left_too told user i))
      user.instances
  in
  Array.for_all by_user program.nodes && !users > 0

let rewrite (nodes : Ir.node array) ~fresh index (m : Ir.machine) { mode; arguments; ends } =
  let equations = ref [] and instances = ref [] in
  let signal ty : Ir.signal =
    let id = fresh () in
    { id; name = ""; ty; group = id; span = m.span }
  in
  let define (s : Ir.signal) rhs =
    equations := { Ir.defines = s; rhs; span = m.span } :: !equations
  in
  let names = Names.create () in
  let taken (i : Ir.instance) = ignore (Names.unique names i.name : string) in
  List.iter taken nodes.(index).instances;
  let run node statics others : Ir.atom list =
    let outputs = List.map (fun (s : Ir.signal) -> signal s.ty) m.outputs @ others in
    let name = Names.unique names nodes.(node).origin in
    let inputs = m.inputs and span = m.span in
    instances :=
      { Ir.node; name; statics; inputs; outputs; loop = None; trials = []; span } :: !instances;
    List.filteri (fun k _ -> k < List.length m.outputs) (List.map (fun s -> Ir.Signal s) outputs)
  in
  (* The mode also returns the conditions and arguments of its transitions. *)
  let asked = List.concat_map (fun ((t : Ir.transition), _) -> t.occurs :: t.arguments) ends in
  let others = List.map (fun a -> signal (Operands.ty a)) asked in
  let of_mode = run mode arguments others in
  let rec choose ends others =
    match (ends, others) with
    | ((t : Ir.transition), node) :: ends, condition :: others ->
        let given, others = Long_list.split_at (List.length t.arguments) others in
        let at_end = run node (List.map (fun s -> Ir.Signal s) given) [] in
        nodes.(node) <- { (nodes.(node)) with kind = Function };
        let either then_ else_ : Ir.atom =
          let chosen = signal (Operands.ty then_) in
          define chosen (If { condition = Signal condition; then_; else_ });
          Signal chosen
        in
        List.map2 either at_end (choose ends others)
    | _, _ -> of_mode
  in
  List.iter2 (fun s atom -> define s (Copy atom)) m.outputs (choose ends others);
  let node = nodes.(index) in
  nodes.(index) <-
    {
      node with
      equations = List.rev_append !equations node.equations;
      instances = node.instances @ List.rev !instances;
      machine = None;
    };
  let given = List.map (fun a -> ("", a)) asked in
  nodes.(mode) <- { (nodes.(mode)) with outputs = nodes.(mode).outputs @ given; transitions = [] }

let program (program : Ir.program) =
  let nodes = Array.copy program.nodes and next = ref program.next_id in
  let fresh () =
    incr next;
    !next - 1
  in
  let machine index (m : Ir.machine) =
    match sole nodes m with
    | Some sole when sole.ends = [] || is_left_by_all program index (told nodes sole.ends) ->
        rewrite nodes ~fresh index m sole
    | Some _ | None -> ()
  in
  let node index (node : Ir.node) = Option.iter (machine index) node.machine in
  Array.iteri node program.nodes;
  if !next = program.next_id then program else { program with nodes; next_id = !next }
