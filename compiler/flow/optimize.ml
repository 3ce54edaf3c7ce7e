(* A latch that is a constant simplifies what reads it; it takes a simple
   condition to see it. *)
let simplify program =
  let simple = Simplify.program program in
  let unlatched = Latch.program simple in
  if unlatched == simple then simple else Simplify.program unlatched

(* Literals first, as they decide choices; sharing after simplifying, which
   makes equal what looked different; dead code last, for what all of them
   leave behind. *)
let tidy program =
  program |> Specific.program |> simplify |> Share.program |> Twins.program
  |> Twin_parameters.program |> Unreachable.program |> Dead.program

let program program =
  (* Before inlining, so that sizes are those of the work that remains, and
     what is done twice is inlined once. *)
  let tidied = tidy program in
  (* Before inlining, which takes the joined loops' bodies together. *)
  let tidied = Fusion.program tidied in
  let inlined = Inline.program tidied in
  (* Inlined equations meet their arguments. *)
  let tidied = if inlined == tidied then tidied else tidy inlined in
  (* Last, for a machine that so becomes a part of its user is inlined no more. *)
  let absorbed = Absorb.program tidied in
  if absorbed == tidied then tidied else Dead.program absorbed
