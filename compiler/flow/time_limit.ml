(* In nanoseconds. The root's dt is no longer than that. *)
let most = 1e18

(* Nodes that run in a machine that has instants of its own. *)
let with_own_instants (program : Ir.program) =
  let found = Array.make (Array.length program.nodes) false in
  (* Callers come after callees. *)
  for k = Array.length program.nodes - 1 downto 0 do
    let node = program.nodes.(k) in
    List.iter (fun (i : Ir.instance) -> if found.(k) then found.(i.node) <- true) node.instances;
    Option.iter
      (fun (m : Ir.machine) ->
        if found.(k) || Option.is_some m.active then
          List.iter (fun mode -> found.(mode) <- true) m.modes)
      node.machine
  done;
  found

let ends_in_time (node : Ir.node) =
  let is_time (atom : Ir.atom) =
    match atom with
    | Signal s ->
        List.exists
          (fun (e : Ir.equation) -> e.defines.id = s.id && e.rhs = Time { unit = Nanoseconds; restart = Bool false })
          node.equations
    | Bool _ | Int _ | Float _ -> false
  in
  let known = lazy (Truth.while_running node []) in
  List.exists
    (fun (e : Ir.equation) ->
      match e.rhs with
      | Op (Less_equal, [ Float limit; time ]) when limit <= most && is_time time ->
          Truth.value (Lazy.force known) (Signal e.defines) = Some false
      | _ -> false)
    node.equations

let is_limited program =
  let with_own_instants = lazy (with_own_instants program) in
  fun k ->
    let node = program.Ir.nodes.(k) in
    node.transitions <> [] && ends_in_time node && not (Lazy.force with_own_instants).(k)
