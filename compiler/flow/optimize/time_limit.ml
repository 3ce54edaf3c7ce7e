(* Maximum time limit in nanoseconds; also an upper bound for the root's dt. *)
let most = 1e18

(* Nodes inside a machine that does not run in every instant. *)
let with_own_instants (program : Ir.program) =
  let found = Array.make (Array.length program.nodes) false in
  (* Callers come after callees in the program, so the loop runs backwards. *)
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

(* The conditions that tell whether the local time has reached a limit. *)
let reached (node : Ir.node) =
  let definition : Ir.atom -> Ir.rhs option = function
    | Signal s ->
        List.find_opt (fun (e : Ir.equation) -> e.defines.id = s.id) node.equations
        |> Option.map (fun (e : Ir.equation) -> e.rhs)
    | Bool _ | Int _ | Float _ -> None
  in
  let is_time atom =
    match definition atom with
    | Some (Op (Elementary Nanoseconds, [ time ])) ->
        definition time = Some (Time { restart = Bool false })
    | Some _ | None -> false
  in
  List.filter_map
    (fun (e : Ir.equation) ->
      match e.rhs with
      | Op (Less_equal, [ Float limit; time ]) when limit <= most && is_time time -> Some e.defines
      | _ -> None)
    node.equations

(* A mode continues only in an instant in which none of its transitions occurs. *)
let is_limited program =
  let with_own_instants = lazy (with_own_instants program) in
  fun k ->
    let node = program.Ir.nodes.(k) in
    let known = lazy (Truth.while_running node []) in
    let ends s = Truth.value (Lazy.force known) (Signal s) = Some false in
    node.transitions <> []
    && List.exists ends (reached node)
    && not (Lazy.force with_own_instants).(k)
