(* Literals first, as they decide choices; sharing after simplifying, which
   makes equal what looked different; dead code last, for what all of them
   leave behind. *)
let tidy program =
  program |> Specific.program |> Simplify.program |> Share.program |> Dead.program

let size (program : Ir.program) =
  Array.fold_left
    (fun size (node : Ir.node) ->
      size + List.length node.equations + List.length node.instances)
    0 program.nodes

(* What one round shares may make further choices and differences known. More
   than a second round rarely finds anything. *)
let tidy_twice program =
  let once = tidy program in
  if size once < size program then tidy once else once

let program program =
  (* Before inlining, so that sizes are those of the work that remains, and
     what is done twice is inlined once. *)
  let tidied = tidy program in
  let inlined = Inline.program tidied in
  (* Inlined equations meet their arguments. *)
  if inlined == tidied then tidied else tidy_twice inlined
