(* Maps each index to the first index with the same key. *)
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

(* Nodes that keep all their parameters: foreign C functions, the root, and nodes with trial steps,
   because a trial step does not receive all arguments. *)
let apart (program : Ir.program) =
  let apart = Array.map (fun (node : Ir.node) -> Option.is_some node.foreign) program.nodes in
  apart.(Array.length apart - 1) <- true;
  let instance (i : Ir.instance) = if i.trials <> [] then apart.(i.node) <- true in
  Array.iter (fun (node : Ir.node) -> List.iter instance node.instances) program.nodes;
  apart

(* Maps each parameter of each node to the representative of its equivalence class. At first, all
   parameters of one type are equivalent. Calls split the classes until no call splits any class
   further. *)
let representatives (program : Ir.program) parameters =
  let apart = apart program and place = Passed.places program in
  let of_type k (all : Ir.signal array) =
    if apart.(k) then Array.mapi (fun j _ -> j) all
    else
      (* A static parameter keeps its value from the start of the mode, so it is never equivalent to
         an input. *)
      let statics = List.length program.nodes.(k).statics in
      firsts (Array.mapi (fun j (s : Ir.signal) -> (j < statics, s.ty)) all)
  in
  let representatives = Array.mapi of_type parameters in
  let key atom : Operands.key =
    match place atom with
    | Some (k, j) -> Signal parameters.(k).(representatives.(k).(j)).id
    | None -> Operands.key atom
  in
  let split { Passed.callee; arguments } =
    let before = representatives.(callee) in
    (* Accumulators of a loop are never equivalent, because each of them gets its own value in each
       iteration. *)
    let passed j (how, atom) = (before.(j), how, key atom, if how = Ir.Accumulator then j else 0) in
    representatives.(callee) <- firsts (Array.mapi passed arguments);
    representatives.(callee) <> before
  in
  Passed.settle program split;
  representatives

let program (program : Ir.program) =
  let parameters = Array.map Passed.parameters program.nodes in
  let representatives = representatives program parameters in
  Passed.replaced program (fun k j ->
      let first = representatives.(k).(j) in
      if first = j then None else Some (Signal parameters.(k).(first)))
