type t = { resets : bool array; starts : bool array }

let reset t k = t.resets.(k)
let start t k = t.starts.(k)

let of_program (program : Ir.program) =
  let count = Array.length program.nodes in
  let t = { resets = Array.make count false; starts = Array.make count false } in
  t.resets.(count - 1) <- true;
  (* Callers come after what they call. *)
  for k = count - 1 downto 0 do
    let node = program.nodes.(k) in
    let entry (e : Ir.entry) =
      let mode : Ir.mode = List.nth node.modes e.mode in
      match (mode.state, e.first) with
      | None, _ -> ()
      | Some _, Reset_by _ -> t.resets.(mode.node) <- true
      | Some _, Started_by _ -> t.starts.(mode.node) <- true
    in
    let run (r : Ir.run) =
      Option.iter entry r.start;
      List.iter (fun (_, e) -> entry e) r.controls;
      List.iter
        (fun (case : Ir.case) -> List.iter (fun (n : Ir.next) -> entry n.entry) case.transitions)
        r.cases
    in
    let statement : Ir.statement -> unit = function
      | Reset { node; _ } -> t.resets.(node) <- true
      | Start { node; _ } -> t.starts.(node) <- true
      | Enter { entry = e; _ } | Begin { entry = e; _ } -> entry e
      | Run r -> run r
      | Declare _ | Assign _ | If _ | Step _ | Loop _ | Await _ | Return _ -> ()
    in
    let code (code : Ir.code) = Walk.statements statement code.body in
    code node.step;
    if t.resets.(k) then code node.reset;
    if t.starts.(k) then Option.iter code node.start
  done;
  t
