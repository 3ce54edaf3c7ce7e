(* The program after [pass], and whether any node is another one after [last], which
   comes after it. *)
let each_node_and pass ~last program =
  let found = ref false in
  let pass ~fresh node =
    let node = pass ~fresh node in
    let after = last node in
    if after != node then found := true;
    after
  in
  let program = Each_node.program pass program in
  (program, !found)

(* A condition may be the same as another one, or a constant. A latch that is a constant
   simplifies what reads it; it takes a simple condition to see it. Sharing after
   simplifying, which makes equal what looked different. *)
let tidy_nodes (program : Ir.program) =
  let simplify ~fresh node = Simplify.node program.real ~fresh node in
  let simplify_if needed ~fresh node = if needed then simplify ~fresh node else node in
  let program, found = each_node_and simplify ~last:Condition.node program in
  let program, found = each_node_and (simplify_if found) ~last:Latch.node program in
  Each_node.program
    (fun ~fresh node -> node |> simplify_if found ~fresh |> Share.node)
    program

(* Literals first, as they decide choices; dead code last, for what all of them leave
   behind. *)
let tidy_once program =
  program |> Specific.program |> tidy_nodes |> Twins.program |> Twin_parameters.program
  |> Unreachable.program |> Dead.program

let modes (program : Ir.program) =
  Array.fold_left
    (fun n (node : Ir.node) ->
      Option.fold node.machine ~none:n ~some:(fun (m : Ir.machine) -> n + List.length m.modes))
    0 program.nodes

(* Of a machine with fewer modes more can be said: what is left may put out the
   same literal, or get it. *)
let rec tidy program =
  let tidied = tidy_once program in
  if modes tidied < modes program then tidy tidied else tidied

let inline program =
  let inlined = Inline.program program in
  if inlined == program then program
  else
    (* Inlined equations meet their arguments, and then what they share with their
       new neighbours. *)
    let tidied = tidy inlined in
    let simple = Simplify.program tidied in
    if simple == tidied then tidied else Dead.program simple

let program program =
  (* Before inlining, so that sizes are those of the work that remains, and
     what is done twice is inlined once. *)
  let tidied = tidy program in
  (* Before inlining, which takes the joined loops' bodies together. *)
  let tidied = inline (Fusion.program tidied) in
  (* Loops that stood in other nodes may be joined now; so may those that started
     from what is known now. *)
  let joined = Fusion.program tidied in
  let tidied = if joined == tidied then tidied else inline joined in
  (* Last, for a machine that so becomes a part of its user is inlined no more. *)
  let absorbed = Absorb.program tidied in
  if absorbed == tidied then tidied else Dead.program absorbed
