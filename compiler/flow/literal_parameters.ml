open Basis

(* Every list of arguments for the statics of a node. *)
let each_call (program : Ir.program) visit =
  let instance (i : Ir.instance) = visit i.node i.statics in
  let machine (m : Ir.machine) =
    let modes = Array.of_list m.modes in
    Transitions.into program m (fun (t : Ir.transition) -> visit modes.(t.target) t.arguments)
  in
  Array.iter
    (fun (node : Ir.node) ->
      List.iter instance node.instances;
      Option.iter machine node.machine)
    program.nodes

let is_literal : Ir.atom -> bool = function
  | Bool _ | Int _ | Float _ -> true
  | Signal _ -> false

let passed (program : Ir.program) =
  let all = Int_table.create 64 in
  let note (s : Ir.signal) a =
    match (Int_table.find_opt all s.id, is_literal a) with
    | None, true -> Int_table.replace all s.id (Some [ a ])
    | Some (Some others), true -> Int_table.replace all s.id (Some (a :: others))
    | Some None, _ -> ()
    | _, false -> Int_table.replace all s.id None
  in
  each_call program (fun k -> List.iter2 note program.nodes.(k).statics);
  fun (s : Ir.signal) -> Option.join (Int_table.find_opt all s.id)

let is_operation : Ir.rhs -> bool = function
  | Copy _ | Op _ | If _ -> true
  | Is_constructor _ | Payload _ | Construct _ | Elements _ | Absent | Fill _ | Index _ | At _
  | Replace _ | Delay _ | Time _ | Ticks _ | Integral _ | Derivative _ ->
      false

(* The equations that compute something of this parameter and constants alone, in
   an order in which they can be computed. *)
let computed_of (parameter : Ir.signal) (node : Ir.node) =
  let known = Int_table.create 8 in
  Int_table.replace known parameter.id ();
  let is_of_it (e : Ir.equation) =
    is_operation e.rhs
    && (not (Int_table.mem known e.defines.id))
    && (match Operands.signals (Operands.all e.rhs) with
       | [] -> false
       | signals -> List.for_all (fun (s : Ir.signal) -> Int_table.mem known s.id) signals)
  in
  let rec more found equations =
    match List.partition is_of_it equations with
    | [], _ -> List.rev found
    | now, later ->
        List.iter (fun (e : Ir.equation) -> Int_table.replace known e.defines.id ()) now;
        more (List.rev_append now found) later
  in
  more [] node.equations

(* What the node reads beside the equations [inside]. *)
let read_outside inside (node : Ir.node) =
  let is_inside (e : Ir.equation) = List.memq e inside in
  let of_equation e = if is_inside e then [] else Operands.all e.Ir.rhs in
  let of_instance (i : Ir.instance) =
    i.statics @ i.inputs
    @ List.concat_map (fun (t : Ir.trial) -> List.filter_map Fun.id t.given) i.trials
  in
  let of_machine (m : Ir.machine) = Transitions.read_in_step m @ Transitions.atoms m.start in
  Operands.signals
    (List.concat_map of_equation node.equations
    @ List.concat_map of_instance node.instances
    @ Option.fold node.machine ~none:[] ~some:of_machine
    @ Transitions.atoms node.transitions
    @ List.map snd node.outputs)

(* The one signal that is needed of it, and how it is computed. *)
let needed (node : Ir.node) (parameter : Ir.signal) =
  match computed_of parameter node with
  | [] -> None
  | computed -> (
      let is_of_it (s : Ir.signal) =
        s.id = parameter.id
        || List.exists (fun (e : Ir.equation) -> e.defines.id = s.id) computed
      in
      match List.filter is_of_it (read_outside computed node) with
      | first :: others
        when first.id <> parameter.id
             && List.for_all (fun (s : Ir.signal) -> s.id = first.id) others ->
          Some (first, computed)
      | _ -> None)

let rec literal known : Ir.atom -> Ir.atom option = function
  | Signal s -> Option.bind (Int_table.find_opt known s.Ir.id) (literal known)
  | (Bool _ | Int _ | Float _) as a -> Some a

(* What it is if the parameter is that literal. *)
let value real (parameter : Ir.signal) ((result : Ir.signal), computed) (given : Ir.atom) =
  let known = Int_table.create 8 in
  Int_table.replace known parameter.id given;
  let literal = literal known in
  let compute (e : Ir.equation) =
    let value =
      match e.rhs with
      | Copy a -> literal a
      | Op (operator, arguments) ->
          Fold.operation real operator (List.filter_map literal arguments)
      | If { condition; then_; else_ } -> (
          match literal condition with
          | Some (Bool true) -> literal then_
          | Some (Bool false) -> literal else_
          | Some _ | None -> None)
      | _ -> None
    in
    Option.iter (Int_table.replace known e.defines.id) value
  in
  List.iter compute computed;
  literal (Signal result)

(* A time to wait stays one; else it is not what the programmer calls by that name. *)
let name (node : Ir.node) (parameter : Ir.signal) (result : Ir.signal) =
  let definition (s : Ir.signal) =
    List.find_map
      (fun (e : Ir.equation) -> if e.defines.id = s.id then Some e.rhs else None)
      node.equations
  in
  let asks_time (e : Ir.equation) =
    match e.rhs with
    | Op (Less_equal, [ Signal s; Signal time ]) when s.id = result.id -> (
        match definition time with Some (Time _) -> true | Some _ | None -> false)
    | _ -> false
  in
  match (result.name, parameter.name, definition result) with
  | "", "", _ -> ""
  | "", name, _ when List.exists asks_time node.equations -> name
  | "", name, Some (Op (Elementary f, _)) -> Core.Primitive.name (Elementary f) ^ "_" ^ name
  | "", name, _ -> name ^ "_value"
  | name, _, _ -> name

type replacement = {
  parameter : Ir.signal;
  result : Ir.signal;
  computed : Ir.equation list;
  by : Ir.signal;
  values : (Ir.atom * Ir.atom) list;  (** of each literal passed *)
}

let replacement real fresh literals node parameter =
  match needed node parameter with
  | None -> None
  | Some ((result, computed) as needed) ->
      let add values given =
        match (values, value real parameter needed given) with
        | Some values, Some value -> Some ((given, value) :: values)
        | None, _ | _, None -> None
      in
      List.fold_left add (Some []) literals
      |> Option.map (fun values ->
             let name = name node parameter result in
             let id = fresh () in
             { parameter; result; computed; by = { result with id; group = id; name }; values })

(* The node without what is computed for it now. *)
let apply replacements (node : Ir.node) =
  let substitution = Substitution.create () in
  let gone = List.concat_map (fun r -> r.computed) replacements in
  List.iter (fun r -> Substitution.replace substitution r.result (Signal r.by)) replacements;
  let static (s : Ir.signal) =
    match List.find_opt (fun r -> r.parameter.id = s.id) replacements with
    | Some r -> r.by
    | None -> s
  in
  Substitution.node substitution
    {
      node with
      statics = List.map static node.statics;
      equations = List.filter (fun e -> not (List.memq e gone)) node.equations;
    }

(* What is passed instead. *)
let arguments replacements (statics : Ir.signal list) =
  List.map2
    (fun (s : Ir.signal) given ->
      match List.find_opt (fun r -> r.parameter.id = s.id) replacements with
      | None -> given
      | Some r -> snd (List.find (fun (literal, _) -> Operands.same literal given) r.values))
    statics

let program (program : Ir.program) =
  let passed = passed program in
  let next = ref program.next_id in
  let fresh () =
    let id = !next in
    incr next;
    id
  in
  let of_node (node : Ir.node) =
    if Option.is_some node.foreign then []
    else
      List.filter_map
        (fun s ->
          Option.bind (passed s) (fun literals -> replacement program.real fresh literals node s))
        node.statics
  in
  let replacements = Array.map of_node program.nodes in
  if Array.for_all (fun of_node -> of_node = []) replacements then program
  else
    let given k atoms =
      match replacements.(k) with
      | [] -> atoms
      | of_node -> arguments of_node program.nodes.(k).statics atoms
    in
    let owners = Transitions.owners program in
    let node k (node : Ir.node) =
      let transition (machine : Ir.machine) (t : Ir.transition) =
        { t with arguments = given (List.nth machine.modes t.target) t.arguments }
      in
      let machine (m : Ir.machine) =
        {
          m with
          start = List.map (transition m) m.start;
          controls = List.map (transition m) m.controls;
        }
      in
      let transitions =
        match Option.map (fun owner -> program.nodes.(owner).machine) owners.(k) with
        | Some (Some machine) -> List.map (transition machine) node.transitions
        | Some None | None -> node.transitions
      in
      apply replacements.(k)
        {
          node with
          instances =
            Long_list.map
              (fun (i : Ir.instance) -> { i with statics = given i.node i.statics })
              node.instances;
          machine = Option.map machine node.machine;
          transitions;
        }
    in
    let nodes = Array.mapi node program.nodes in
    { program with nodes; next_id = !next }
