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
let twins (program : Ir.program) parameters =
  let apart = apart program and place = Passed.places program in
  let of_type k (all : Ir.signal array) =
    if apart.(k) then Array.mapi (fun j _ -> j) all
    else
      (* What a mode was given when it started may be another thing now. *)
      let statics = List.length program.nodes.(k).statics in
      firsts (Array.mapi (fun j (s : Ir.signal) -> (j < statics, s.ty)) all)
  in
  let twins = Array.mapi of_type parameters in
  let key atom : Operands.key =
    match place atom with
    | Some (k, j) -> Signal parameters.(k).(twins.(k).(j)).id
    | None -> Operands.key atom
  in
  let tell_apart { Passed.callee; arguments } =
    let before = twins.(callee) in
    (* What an accumulator becomes is its own. *)
    let passed j (how, atom) = (before.(j), how, key atom, if how = Ir.Accumulator then j else 0) in
    twins.(callee) <- firsts (Array.mapi passed arguments);
    twins.(callee) <> before
  in
  Passed.settle program tell_apart;
  twins

let program (program : Ir.program) =
  let parameters = Array.map Passed.parameters program.nodes in
  let twins = twins program parameters in
  Passed.replaced program (fun k j ->
      let first = twins.(k).(j) in
      if first = j then None else Some (Signal parameters.(k).(first)))
