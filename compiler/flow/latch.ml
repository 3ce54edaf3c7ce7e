(* What is known of Bools at an instant, by signal id. *)
type known = {
  definitions : (int, Ir.rhs) Hashtbl.t;
  values : (int, bool) Hashtbl.t;
}

(* Deeper than a person writes a condition, and not so deep that it takes long. *)
let depth = 6

let rec value ?(depth = depth) known (atom : Ir.atom) =
  let value known a = if depth = 0 then None else value ~depth:(depth - 1) known a in
  match atom with
  | Bool b -> Some b
  | Int _ | Float _ -> None
  | Signal s -> (
      match Hashtbl.find_opt known.values s.id with
      | Some b -> Some b
      | None -> (
          match Hashtbl.find_opt known.definitions s.id with
          | Some (Copy a) -> value known a
          | Some (Op (Not, [ a ])) -> Option.map not (value known a)
          | Some (Op (And, [ a; b ])) -> (
              match (value known a, value known b) with
              | Some false, _ | _, Some false -> Some false
              | Some true, Some true -> Some true
              | None, _ | _, None -> None)
          | Some (Op (Or, [ a; b ])) -> (
              match (value known a, value known b) with
              | Some true, _ | _, Some true -> Some true
              | Some false, Some false -> Some false
              | None, _ | _, None -> None)
          | Some _ | None -> None))

(* Learns that an atom has this value, and what follows for its operands. *)
let rec learn ?(depth = depth) known (atom : Ir.atom) b =
  let learn known a b = if depth > 0 then learn ~depth:(depth - 1) known a b in
  match atom with
  | Bool _ | Int _ | Float _ -> ()
  | Signal s -> (
      Hashtbl.replace known.values s.id b;
      match (Hashtbl.find_opt known.definitions s.id, b) with
      | Some (Copy a), _ -> learn known a b
      | Some (Op (Not, [ a ])), _ -> learn known a (not b)
      | Some (Op (And, [ x; y ])), true | Some (Op (Or, [ x; y ])), false ->
          learn known x b;
          learn known y b
      | Some (Op (And, [ x; y ])), false | Some (Op (Or, [ x; y ])), true -> (
          let other = not b in
          match (value known x, value known y) with
          | Some v, None when Bool.equal v other -> learn known y b
          | None, Some v when Bool.equal v other -> learn known x b
          | _, _ -> ())
      | _, _ -> ())

(* More than a mode has, and it keeps this linear. *)
let most_candidates = 16

let node (node : Ir.node) =
  if node.transitions = [] then node
  else
    let definitions = Hashtbl.create 64 in
    List.iter
      (fun (e : Ir.equation) ->
        if e.defines.ty = Bool then Hashtbl.replace definitions e.defines.id e.rhs)
      node.equations;
    let stays (s : Ir.signal) b next =
      let known = { definitions; values = Hashtbl.create 16 } in
      Hashtbl.replace known.values s.id b;
      List.iter (fun (t : Ir.transition) -> learn known t.occurs false) node.transitions;
      value known next = Some b
    in
    let candidates = ref 0 in
    let constant (e : Ir.equation) : Ir.equation =
      match e.rhs with
      | Delay { init = Bool b; next } when !candidates < most_candidates ->
          incr candidates;
          if stays e.defines b next then { e with rhs = Copy (Bool b) } else e
      | _ -> e
    in
    let equations = List.map constant node.equations in
    if List.for_all2 ( == ) equations node.equations then node else { node with equations }

let program (program : Ir.program) =
  let nodes = Array.map node program.nodes in
  if Array.for_all2 ( == ) nodes program.nodes then program else { program with nodes }
