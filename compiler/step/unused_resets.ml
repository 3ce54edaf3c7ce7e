(* The nodes whose reset is called, and the root. *)
let called (program : Ir.program) =
  let count = Array.length program.nodes in
  let called = Array.make count false in
  called.(count - 1) <- true;
  (* Callers come after callees. *)
  for k = count - 1 downto 0 do
    let node = program.nodes.(k) in
    let entry (e : Ir.entry) =
      let mode : Ir.mode = List.nth node.modes e.mode in
      if Option.is_some mode.state then called.(mode.node) <- true
    in
    let run (r : Ir.run) =
      List.iter (fun (_, e) -> entry e) r.controls;
      List.iter
        (fun (case : Ir.case) -> List.iter (fun (n : Ir.next) -> entry n.entry) case.transitions)
        r.cases
    in
    let statement : Ir.statement -> unit = function
      | Reset { node; _ } -> called.(node) <- true
      | Enter { entry = e; _ } -> entry e
      | Run r -> run r
      | Declare _ | Assign _ | If _ | Step _ | Loop _ | Return _ -> ()
    in
    Walk.statements statement node.step.body;
    if called.(k) then Walk.statements statement node.reset.body
  done;
  called

let program (program : Ir.program) =
  let called = called program in
  let node k (node : Ir.node) =
    if called.(k) then node else { node with reset = { parameters = []; body = [] } }
  in
  { program with nodes = Array.mapi node program.nodes }
