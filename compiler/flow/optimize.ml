(* A condition may be the same as another one, or a constant. A latch that is a constant
   simplifies what reads it; it takes a simple condition to see it. *)
let simplify program =
  let simple = Simplify.program program in
  let simpler = Condition.program simple in
  let simple = if simpler == simple then simple else Simplify.program simpler in
  let unlatched = Latch.program simple in
  if unlatched == simple then simple else Simplify.program unlatched

(* Literals first, as they decide choices; sharing after simplifying, which
   makes equal what looked different; dead code last, for what all of them
   leave behind. *)
let tidy_once program =
  program |> Specific.program |> simplify |> Parity.program |> Share.program |> Twins.program
  |> Twin_parameters.program |> Unreachable.program |> Dead.program

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
    tidy inlined |> Simplify.program |> Dead.program

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
  (* When it is known who runs a machine, and what its modes put out. *)
  let awaited = Waiting.program tidied in
  let tidied = if awaited == tidied then tidied else tidy awaited in
  (* When loops are what they will be. *)
  let started = Extreme.program tidied in
  (* Last, for a machine that so becomes a part of its user is inlined no more. *)
  let absorbed = Absorb.program started in
  (* When what is computed of a parameter stands where it is read. *)
  let derived = Derived_parameters.program absorbed in
  let computed = Literal_parameters.program derived in
  if computed == tidied then tidied else Dead.program computed
