let is_literal : Ir.atom -> bool = function
  | Bool _ | Int _ | Float _ -> true
  | Signal _ -> false

let only_waits (mode : Ir.node) =
  mode.transitions = [] && Option.is_none mode.machine && mode.instances = []
  && List.for_all (fun (_, atom) -> is_literal atom) mode.outputs

(* What the mode before puts out for an output, if it tells itself that all is [over]. *)
let instead (use : Over.use) over before (waiting : Ir.atom) =
  if Operands.same before waiting then Some before
  else
    match (before, waiting) with
    | Bool false, Bool true -> Some over
    | (Bool _ | Int _ | Float _ | Signal _), _ -> if use.drops then Some before else None

(* Do the users end where the mode is entered? *)
let ends uses (waiting : Ir.node) =
  let is_true : Ir.atom -> bool = function Bool b -> b | Int _ | Float _ | Signal _ -> false in
  List.exists2 (fun (use : Over.use) (_, atom) -> use.ends && is_true atom) uses waiting.outputs

type work = { nodes : Ir.node array; mutable fresh : int; mutable changed : bool }

let equation work (t : Ir.transition) rhs : Ir.equation =
  let id = work.fresh in
  work.fresh <- id + 1;
  { defines = { id; name = ""; ty = Bool; group = id; span = t.span }; rhs; span = t.span }

(* Equations for it: is the last transition the one that occurs? *)
let occurs work (last : Ir.transition) earlier =
  let and_not (equations, atom) (t : Ir.transition) =
    let not_ = equation work t (Op (Not, [ t.occurs ])) in
    let and_ = equation work t (Op (And, [ atom; Signal not_.defines ])) in
    (not_ :: and_ :: equations, Ir.Signal and_.defines)
  in
  List.fold_left and_not ([], last.occurs) earlier

(* The mode's last transition is the one that leads to the other. *)
let tell work uses index ~(waiting : Ir.node) (last : Ir.transition) earlier =
  let before = work.nodes.(index) in
  let equations, over = occurs work last earlier in
  let outputs =
    List.map2
      (fun (use, (_, before)) (_, waiting) -> instead use over before waiting)
      (List.combine uses before.outputs)
      waiting.outputs
  in
  if List.for_all Option.is_some outputs then (
    work.changed <- true;
    work.nodes.(index) <-
      {
        before with
        outputs = List.map2 (fun (name, _) atom -> (name, Option.get atom)) before.outputs outputs;
        equations = before.equations @ equations;
        transitions = earlier;
      })

let mode work uses modes index =
  match List.rev work.nodes.(index).transitions with
  | ({ delayed = false; target; _ } as last) :: earlier when modes.(target) <> index ->
      let waiting = work.nodes.(modes.(target)) in
      if only_waits waiting && ends uses waiting then
        tell work uses index ~waiting last (List.rev earlier)
  | _ -> ()

let program (program : Ir.program) =
  let work =
    { nodes = Array.copy program.nodes; fresh = program.next_id; changed = false }
  in
  let uses = Over.uses program in
  let machine index (m : Ir.machine) =
    match if m.controls = [] && m.active = None then uses index else [] with
    | [] -> ()
    | uses -> List.iter (mode work uses (Array.of_list m.modes)) m.modes
  in
  Array.iteri (fun index (node : Ir.node) -> Option.iter (machine index) node.machine) program.nodes;
  if work.changed then { program with nodes = work.nodes; next_id = work.fresh } else program
