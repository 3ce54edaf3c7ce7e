type t = { steps : bool array; resets : bool array }

let in_step t k = t.steps.(k)
let in_reset t k = t.resets.(k)

let reads t (node : Ir.node) body =
  let found = ref false in
  let note yes = if yes then found := true in
  let entry (e : Ir.entry) = note t.resets.((List.nth node.modes e.mode).node) in
  let run (r : Ir.run) =
    List.iter (fun (_, e) -> entry e) r.controls;
    List.iter2
      (fun (mode : Ir.mode) (case : Ir.case) ->
        note t.steps.(mode.node);
        List.iter (fun (n : Ir.next) -> entry n.entry) case.transitions)
      node.modes r.cases
  in
  Walk.expressions
    (function Ir.Param _ -> note true | Call { node; _ } -> note t.steps.(node) | _ -> ())
    body;
  Walk.statements
    (function
      | Ir.Step { node; _ } | Loop { node; _ } -> note t.steps.(node)
      | Reset { node; _ } -> note t.resets.(node)
      | Enter { entry = e; _ } -> entry e
      | Run r -> run r
      | Declare _ | Assign _ | If _ | Return _ -> ())
    body;
  !found

(* Callees come before callers, so one pass over the nodes is enough. *)
let of_program (program : Ir.program) =
  let count = Array.length program.nodes in
  let t = { steps = Array.make count false; resets = Array.make count false } in
  if program.params <> [] then
    Array.iteri
      (fun k (node : Ir.node) ->
        t.resets.(k) <- reads t node node.reset.body;
        t.steps.(k) <- reads t node node.step.body)
      program.nodes;
  t
