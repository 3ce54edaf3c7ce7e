module F = Flow.Ir

type t = {
  step : Ir.statement list;
  reset : Ir.statement list;
  told : Ir.first_instant;
}

let shows state (eq : F.equation) =
  match State.memory state eq.defines with
  | None -> eq.rhs = Step_time
  | Some (Elapsed _ | Ticked _ | Differentiated _) -> true
  | Some (Integrated { input = Field _; _ } | Delayed _ | Kept _) -> false
  | Some (Integrated _) -> true

let shows_in state statics = List.exists (shows state) (Statics.equations_in_step statics)

(* The number of a mode may be one byte. *)
let most_modes_and_none = 255

(* The first mode is entered in the first step, where that is short: the number
   of the mode then tells that there was no step before. *)
let started_by_step ~callee modes first (step : Ir.statement list) (reset : Ir.statement list) =
  let run (s : Ir.statement) : Ir.statement =
    match s with
    | Run run when Direct.is_direct run && Option.is_none run.active -> 
        Run { run with start = Some (Entry.started ~callee modes run first) }
    | s -> s
  in
  let step' = List.map run step in
  if List.for_all2 ( == ) step step' then None
  else
    let await (s : Ir.statement) : Ir.statement =
      match s with Enter { span; _ } -> Await { span } | s -> s
    in
    Some (step', List.map await reset)

let entered_by_step (context : Calls.context) state (node : F.node) step reset =
  let modes = State.modes state in
  let count = List.length modes in
  if count > 1 && count <= most_modes_and_none then
    Option.bind (Body.first_mode context state node) (fun first ->
        started_by_step ~callee:context.callee modes first step reset)
  else None

(* A delay of the programmer's that is false in the first instant, then true. *)
let marked state statics =
  List.find_map
    (fun (eq : F.equation) ->
      match (eq.rhs, State.memory state eq.defines) with
      | Delay { init = Bool false; next = Bool true }, Some (Delayed field) -> Some field
      | _, _ -> None)
    (Statics.equations_in_step statics)

(* A single derivative sees the time, and nothing else does. *)
let is_for_one_derivative state statics =
  let see_it (eq : F.equation) =
    match State.memory state eq.defines with
    | Some (Differentiated _) -> [ true ]
    | Some _ | None -> if shows state eq then [ false ] else []
  in
  List.concat_map see_it (Statics.equations_in_step statics) = [ true ]

(* That derivative asks for itself; [mark] is for after it. *)
let asked_by_derivative ~(started : Ir.field) ~mark step =
  let rec ask before (step : Ir.statement list) =
    match step with
    | If ({ condition = Operation { operator = Less; arguments = [ Float 0.; Dt ]; _ } as passed; _ } as i)
      :: after ->
        let condition = Ir.Operation { operator = And; ty = Bool; arguments = [ Field started; passed ] } in
        Some (List.rev_append before ((Ir.If { i with condition } :: mark) @ after))
    | s :: after -> ask (s :: before) after
    | [] -> None
  in
  ask [] step

let tell context state (node : F.node) statics ~callees_see ~step ~reset =
  let asked ~started ~mark =
    if callees_see || not (is_for_one_derivative state statics) then None
    else asked_by_derivative ~started ~mark step
  in
  let assign field value = Ir.Assign { place = Own field; value = Bool value; span = field.Ir.span } in
  match (entered_by_step context state node step reset, marked state statics) with
  | Some (step, reset), _ -> { step; reset; told = Marked_by_mode }
  | None, Some field -> (
      match First_apart.step context.Calls.program.real ~started:field ~reset step with
      | Some step -> { step; reset; told = Apart }
      | None -> (
          match asked ~started:field ~mark:[] with
          | Some step -> { step; reset; told = Unseen }
          | None -> { step; reset; told = Marked_by { field; own = false } }))
  | None, None -> (
      let field =
        State.new_field state ~name:"started" (Value Bool) ~purpose:State.past_first node.span
      in
      let reset = reset @ [ assign field false ] in
      match asked ~started:field ~mark:[ assign field true ] with
      | Some step -> { step; reset; told = Unseen }
      | None -> { step; reset; told = Marked_by { field; own = true } })
