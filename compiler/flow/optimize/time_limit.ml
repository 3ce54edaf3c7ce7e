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

(* The conditions that the time which starts again by [restart] has come to a limit. *)
let reached (node : Ir.node) restart =
  let is_soon : Ir.atom -> bool = function Float limit -> limit <= most | _ -> false in
  let is_time (atom : Ir.atom) =
    let definition : Ir.atom -> Ir.rhs option = function
      | Signal s ->
          List.find_opt (fun (e : Ir.equation) -> e.defines.id = s.id) node.equations
          |> Option.map (fun (e : Ir.equation) -> e.rhs)
      | Bool _ | Int _ | Float _ -> None
    in
    match definition atom with
    | Some (Op (Elementary Nanoseconds, [ time ])) -> (
        match definition time with
        | Some (Time { restart = other }) -> Operands.same other restart
        | Some _ | None -> false)
    | Some _ | None -> false
  in
  List.filter_map
    (fun (e : Ir.equation) ->
      match e.rhs with
      | Op (Less_equal, [ limit; time ]) when is_time time && is_soon limit -> Some e.defines
      | _ -> None)
    node.equations

(* A mode goes on where no transition occurs. *)
let ends_in_time (node : Ir.node) =
  let known = lazy (Truth.while_running node []) in
  node.transitions <> []
  && List.exists
       (fun s -> Truth.value (Lazy.force known) (Signal s) = Some false)
       (reached node (Bool false))

(* Where the limit is reached, what the delays will be then makes it start again. *)
let starts_again_in_time (node : Ir.node) restart =
  let at_an_instant = lazy (Truth.at_an_instant node) in
  let an_instant_later now =
    List.filter_map
      (fun (e : Ir.equation) ->
        match e.rhs with
        | Delay { next; _ } when e.defines.ty = Bool ->
            Option.map (fun b -> (e.defines, b)) (Truth.value now next)
        | _ -> None)
      node.equations
  in
  List.exists
    (fun s ->
      let at_an_instant = Lazy.force at_an_instant in
      let later = an_instant_later (at_an_instant [ (s, true) ]) in
      Truth.value (at_an_instant later) restart = Some true)
    (reached node restart)

let is_limited program =
  let with_own_instants = lazy (with_own_instants program) in
  fun k restart ->
    let node = program.Ir.nodes.(k) in
    (match (restart : Ir.atom) with
    | Signal _ -> starts_again_in_time node restart
    | Bool _ | Int _ | Float _ -> ends_in_time node)
    && not (Lazy.force with_own_instants).(k)
