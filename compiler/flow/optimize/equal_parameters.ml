open Basis

(* What one node passes for the parameters of another, its statics and inputs. *)
type call = { callee : int; arguments : (Ir.argument * Ir.atom) array }

let each_as_given = List.map (fun a -> (Ir.Same, a))

let calls (program : Ir.program) =
  let found = ref [] in
  let call callee arguments = found := { callee; arguments = Array.of_list arguments } :: !found in
  let instance (i : Ir.instance) =
    let inputs =
      match i.loop with
      | None -> each_as_given i.inputs
      | Some l -> List.combine l.arguments i.inputs
    in
    call i.node (each_as_given i.statics @ inputs)
  in
  let machine (m : Ir.machine) =
    let modes = Array.of_list m.modes in
    let transition inputs (t : Ir.transition) =
      call modes.(t.target) (each_as_given (t.arguments @ inputs))
    in
    List.iter (transition m.inputs) (m.start @ m.controls);
    let from_mode mode =
      let node = program.nodes.(mode) in
      List.iter (transition (List.map (fun s -> Ir.Signal s) node.inputs)) node.transitions
    in
    Array.iter from_mode modes
  in
  let node (node : Ir.node) =
    List.iter instance node.instances;
    Option.iter machine node.machine
  in
  Array.iter node program.nodes;
  !found

(* The first index of the same key. *)
let firsts keys =
  let seen = Hashtbl.create 16 in
  let first j key =
    match Hashtbl.find_opt seen key with
    | Some i -> i
    | None ->
        Hashtbl.replace seen key j;
        j
  in
  Array.mapi first keys

(* The nodes with parameters that nobody sees, or that not all get at once. *)
let apart (program : Ir.program) =
  let apart = Array.map (fun (node : Ir.node) -> Option.is_some node.foreign) program.nodes in
  apart.(Array.length apart - 1) <- true;
  let instance (i : Ir.instance) = if i.trials <> [] then apart.(i.node) <- true in
  Array.iter (fun (node : Ir.node) -> List.iter instance node.instances) program.nodes;
  apart

(* Of each parameter of each node the first of its twins. At first all of a type are; each
   call tells some apart, until none does. *)
let twins (program : Ir.program) (parameters : Ir.signal array array) =
  let apart = apart program and calls = calls program in
  let of_type k (all : Ir.signal array) =
    if apart.(k) then Array.mapi (fun j _ -> j) all
    else
      (* What a mode was given when it started may be another thing now. *)
      let statics = List.length program.nodes.(k).statics in
      firsts (Array.mapi (fun j (s : Ir.signal) -> (j < statics, s.ty)) all)
  in
  let twins = Array.mapi of_type parameters in
  let place = Int_table.create 64 in
  let place_all k = Array.iteri (fun j (s : Ir.signal) -> Int_table.replace place s.id (k, j)) in
  Array.iteri place_all parameters;
  let key : Ir.atom -> Operands.key = function
    | Signal s -> (
        match Int_table.find_opt place s.id with
        | Some (k, j) -> Signal parameters.(k).(twins.(k).(j)).id
        | None -> Signal s.id)
    | atom -> Operands.key atom
  in
  let changed = ref true in
  let tell_apart { callee; arguments } =
    let before = twins.(callee) in
    (* What an accumulator becomes is its own. *)
    let passed j (how, atom) =
      (before.(j), how, key atom, if how = Ir.Accumulator then j else 0)
    in
    let now = firsts (Array.mapi passed arguments) in
    if now <> before then (
      twins.(callee) <- now;
      changed := true)
  in
  while !changed do
    changed := false;
    List.iter tell_apart calls
  done;
  twins

let program (program : Ir.program) =
  let parameters =
    Array.map
      (fun (node : Ir.node) -> Array.of_list (node.statics @ node.inputs))
      program.nodes
  in
  let twins = twins program parameters in
  let node k (node : Ir.node) =
    let substitution = Substitution.create () in
    let replace (s : Ir.signal) first = Substitution.replace substitution s (Ir.Signal first) in
    Array.iteri
      (fun j s -> if twins.(k).(j) <> j then replace s parameters.(k).(twins.(k).(j)))
      parameters.(k);
    Substitution.node substitution node
  in
  let nodes = Array.mapi node program.nodes in
  if Array.for_all2 ( == ) nodes program.nodes then program else { program with nodes }
