(* What is passed for a parameter, as far as it can be told apart. *)
type passed =
  | Own of int  (** a parameter of the node that passes it: the first of its twins *)
  | Other of int  (** another signal *)
  | Literal of Ir.atom

let same a b =
  match (a, b) with
  | Own a, Own b | Other a, Other b -> Int.equal a b
  | Literal a, Literal b -> Operands.same a b
  | (Own _ | Other _ | Literal _), _ -> false

(* The first index of those that are together with each. *)
let firsts together array =
  Array.mapi
    (fun j _ ->
      let rec first i = if i = j || together i j then i else first (i + 1) in
      first 0)
    array

(* The atoms that one node passes for the static parameters of another. *)
type call = { by : int; callee : int; arguments : Ir.atom array }

let calls (program : Ir.program) =
  let found = ref [] in
  let call by callee arguments =
    match arguments with
    | [] | [ _ ] -> ()
    | arguments -> found := { by; callee; arguments = Array.of_list arguments } :: !found
  in
  let machine by (m : Ir.machine) =
    let modes = Array.of_list m.modes in
    let transition by (t : Ir.transition) = call by modes.(t.target) t.arguments in
    List.iter (transition by) m.start;
    List.iter (transition by) m.controls;
    Array.iter
      (fun mode -> List.iter (transition mode) program.nodes.(mode).transitions)
      modes
  in
  Array.iteri
    (fun by (node : Ir.node) ->
      List.iter (fun (i : Ir.instance) -> call by i.node i.statics) node.instances;
      Option.iter (machine by) node.machine)
    program.nodes;
  !found

let number (statics : Ir.signal array) id =
  let rec find j =
    if j = Array.length statics then None
    else if statics.(j).id = id then Some j
    else find (j + 1)
  in
  find 0

(* Of each static parameter of each node the first of its twins. At first all of a
   type are; each call tells some apart, until none does. *)
let twins (statics : Ir.signal array array) calls =
  let of_type (s : Ir.signal array) = firsts (fun i j -> s.(i).ty = s.(j).ty) s in
  let twins = Array.map of_type statics in
  let passed by (a : Ir.atom) =
    match a with
    | Signal s -> (
        match number statics.(by) s.id with Some j -> Own twins.(by).(j) | None -> Other s.id)
    | Bool _ | Int _ | Float _ -> Literal a
  in
  let changed = ref true in
  let note { by; callee; arguments } =
    let arguments = Array.map (passed by) arguments in
    let before = twins.(callee) in
    let now =
      firsts (fun i j -> before.(i) = before.(j) && same arguments.(i) arguments.(j)) before
    in
    if now <> before then (
      twins.(callee) <- now;
      changed := true)
  in
  while !changed do
    changed := false;
    List.iter note calls
  done;
  twins

let program (program : Ir.program) =
  let statics =
    Array.map (fun (node : Ir.node) -> Array.of_list node.statics) program.nodes
  in
  let twins = twins statics (calls program) in
  let some = ref false in
  let node k (node : Ir.node) =
    let substitution = Substitution.create () in
    Array.iteri
      (fun j s ->
        let first = twins.(k).(j) in
        if first <> j then Substitution.replace substitution s (Ir.Signal statics.(k).(first)))
      statics.(k);
    if node.foreign = None && Array.exists (Substitution.is_replaced substitution) statics.(k) then (
      some := true;
      Substitution.node substitution node)
    else node
  in
  let nodes = Array.mapi node program.nodes in
  if !some then { program with nodes } else program
