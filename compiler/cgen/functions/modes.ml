open Basis
module V = Vocabulary
open Context

let field_with c has =
  Option.map (Expression.field c.names)
    (List.find_opt (fun (field : M.field) -> has field.content) c.node.state)

let running_mode c = field_with c (function M.Running_mode -> true | _ -> false)

let enter c (entry : M.entry) span =
  let mode = List.nth c.node.modes entry.mode in
  let comment = comment c span in
  let number =
    match running_mode c with
    | Some place -> [ Ir.Assign (place, Name c.v.nodes.(c.index).modes.(entry.mode).constant) ]
    | None -> []
  in
  let parameter (_, field) value = Ir.Assign (Expression.field c.names field, expression c value) in
  let parameters = List.map2 parameter mode.parameters entry.parameters in
  let reset =
    match mode.state with
    | None -> []
    | Some state ->
        let own = own_state c (Some state) in
        [ Ir.Do (Call (c.v.nodes.(mode.node).reset, own @ for_reset c mode.node entry.arguments)) ]
  in
  match number @ parameters @ reset with
  | [] -> []
  | first :: others -> { Ir.desc = first; comment } :: List.map plain others

(* Sets dt to 0 for a mode that is entered in this instant. *)
let forget_time c =
  let set name zero = [ plain (Ir.Assign (Name name, zero)) ] in
  (if c.node.seconds then set "dt" (V.float c.v 0.) else [])
  @ if c.node.nanoseconds then set "dt_ns" (Ir.Integer 0l) else []

(* A chain of [if] statements that runs the first alternative whose condition is true. *)
let first_of alternatives =
  List.fold_right
    (fun (condition, then_, comment) else_ ->
      match condition with
      | Ir.Boolean true -> then_
      | condition -> [ { Ir.desc = If { condition; then_; else_ }; comment } ])
    alternatives []

let ends_early c (mode : M.mode) = Option.is_some c.v.program.nodes.(mode.node).ends_early
let place c (v : M.variable) = expression c (M.Variable v)
let named (_, name) = Ir.Name name

let zero c (v : M.variable) =
  let name = Expression.variable c.names v in
  plain (Ir.Variable { ty = V.ty c.v v.ty; name; value = V.zero c.v v.ty })

(* Results need initial values if C compilers cannot see that every path assigns them. If results
   may be discarded, compilers cannot tell that the first mode always assigns them. If a mode may
   end early, compilers cannot tell that another mode follows. *)
let results_of_run c (run : M.run) ~drops =
  let ends = List.exists (ends_early c) c.node.modes in
  if (not drops) && Option.is_none run.active && not ends then
    List.rev (uninitialized c run.results)
  else List.map (zero c) run.results

(* Calls a mode's step. The step returns a single result, or writes several results to [places]. *)
let call ?entered c (mode : M.mode) (case : M.case) places =
  let state = own_state c mode.state in
  let arguments = for_step c mode.node case.arguments in
  let places = List.map Expression.address places in
  step_call ?entered c ~node:mode.node ~own:state arguments places

let step ?entered c mode case = function
  | [ place ] -> plain (Ir.Assign (place, call ?entered c mode case []))
  | places -> plain (Ir.Do (call ?entered c mode case places))

(* Only steps with at most this many operations are duplicated in each transition to their mode. *)
let direct_size = 24

(* Subtracts from [most] the number of operations in this node's step and in its callees. *)
let rec remaining (program : M.program) most k =
  let node = program.nodes.(k) in
  let most = ref (most - node.operations - 1) in
  let call k = if !most >= 0 then most := remaining program !most k in
  Step.Walk.statements
    (function
      | M.Step { node; _ } | Loop { node; _ } -> call node
      | Run _ -> List.iter (fun (mode : M.mode) -> call mode.node) node.modes
      | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Return _ -> ())
    node.step.body;
  !most

(* Whether a mode takes its first step in the branch of the transition that enters it, rather than
   in another iteration of the loop. This requires that no second transition can follow in the same
   instant. *)
let is_direct c (run : M.run) k =
  let mode = List.nth c.node.modes k in
  run.steps = 2 && (not run.late) && remaining c.v.program direct_size mode.node >= 0

let fresh c (v : M.variable) = (v, Name.fresh (Expression.scope c.names) v.name)

(* The step of the mode that the transition [n] enters. None of that mode's own transitions can
   occur in this instant. *)
let step_directly c (run : M.run) (n : M.next) results =
  let mode = List.nth c.node.modes n.entry.mode and case = List.nth run.cases n.entry.mode in
  let unread = List.map (fresh c) case.others in
  let dropped = if n.delayed then List.map (fresh c) run.results else [] in
  let places = if n.delayed then List.map named dropped else results in
  match places @ List.map named unread with
  | [ _ ] when n.delayed -> [ plain (Ir.Do (call ~entered:true c mode case [])) ]
  | places -> declared c (dropped @ unread) @ [ step ~entered:true c mode case places ]

let one_case c (run : M.run) ~direct ~again ~dropped k (case : M.case) =
  let mode = List.nth c.node.modes k in
  c.place <- "";
  let results = List.map (fun v -> (v, place c v)) run.results in
  (* If results may be discarded, they are first stored in variables that are local to the case. *)
  let own =
    if String.equal dropped "" then []
    else List.map (fun (v, result) -> (fresh c v, result)) results
  in
  let targets =
    if String.equal dropped "" then List.map snd results
    else List.map (fun (own, _) -> named own) own
  in
  let others = List.map (fun v -> (v, Expression.variable c.names v)) case.others in
  let declarations = declared c (List.map fst own @ others) in
  let running = step c mode case (targets @ List.map named others) in
  let keep =
    match own with
    | [] -> []
    | own ->
        let then_ = List.map (fun (v, result) -> plain (Ir.Assign (result, named v))) own in
        [ plain (Ir.If { condition = Unary (Not, Name dropped); then_; else_ = [] }) ]
  in
  let next (n : M.next) =
    let drop =
      if n.delayed && not (String.equal dropped "") then
        [ plain (Ir.Assign (Name dropped, Boolean true)) ]
      else []
    in
    let condition = expression c n.condition in
    let enter = enter c n.entry n.span in
    if direct n then (condition, enter @ step_directly c run n (List.map snd results), "")
    else (condition, enter @ drop @ again, "")
  in
  declarations @ [ running ] @ keep @ first_of (List.map next case.transitions)

let variable ty name value = plain (Ir.Variable { ty; name; value })
let set name value = plain (Ir.Assign (Name name, Boolean value))

(* Uses the time since the machine last ran as its dt. *)
let wake c (clock : M.clock) =
  let since = Expression.field c.names clock.since in
  let seconds = in_seconds c.v (Name "dt_ns") in
  [ plain (Ir.Assign (Name "dt_ns", since)) ]
  @ (if c.node.seconds then [ plain (Ir.Assign (Name "dt", seconds)) ] else [])
  @ [
      plain (Ir.Assign (since, Integer 0l));
      plain (Ir.Assign (Expression.field c.names clock.running, Boolean true));
    ]

(* Adds this instant's dt to the time since the machine last ran. *)
let pass c (clock : M.clock) =
  let since = Expression.field c.names clock.since in
  let condition = Expression.field c.names clock.running in
  let then_ = [ plain (Ir.Assign (since, expression c clock.elapsed)) ] in
  plain (Ir.If { condition; then_; else_ = [] })

let choose c cases =
  match (running_mode c, cases) with
  | None, [ (_, body) ] -> body
  | Some value, cases -> [ plain (Ir.Switch { value; cases }) ]
  | None, _ -> Diagnostic.bug ~stage:"Cgen.Modes" "several modes, but no number of the running mode"

let run c (run : M.run) =
  let flag is_needed name = if is_needed then Name.fresh (Expression.scope c.names) name else "" in
  (* Each iteration runs one mode. There is another iteration if a mode was entered. *)
  let direct = List.mapi (fun k _ -> is_direct c run k) c.node.modes in
  let direct (n : M.next) = List.nth direct n.entry.mode in
  let some_loop has =
    let loop n = has n && not (direct n) in
    run.late || List.exists (fun (case : M.case) -> List.exists loop case.transitions) run.cases
  in
  let loops = run.steps > 1 && some_loop (fun _ -> true) in
  let steps = flag loops "steps" in
  let dropped = flag (run.drops && some_loop (fun n -> n.delayed)) "dropped" in
  let controlled = flag run.late "controlled" in
  let again = if loops then forget_time c @ [ plain Ir.Continue ] else [] in
  let controls after =
    let control (condition, (entry : M.entry)) =
      (expression c condition, enter c entry run.span @ after, "")
    in
    first_of (List.map control run.controls)
  in
  let before = if run.late then [] else controls (forget_time c) in
  let after =
    if not run.late then []
    else
      let entering = set controlled true :: set dropped true :: again in
      let condition = Ir.Unary (Not, Name controlled) in
      [ plain (Ir.If { condition; then_ = controls entering; else_ = [] }) ]
  in
  let case k case =
    (c.v.nodes.(c.index).modes.(k).constant, one_case c run ~direct ~again ~dropped k case)
  in
  let chosen = choose c (List.mapi case run.cases) in
  let stepping =
    if not loops then chosen
    else
      let body = chosen @ after @ [ plain Ir.Break ] in
      [
        variable Int32 steps (Integer 0l);
        plain (Ir.Repeat { rounds = steps; most = run.steps; body });
      ]
  in
  let flags = List.filter (fun name -> not (String.equal name "")) [ dropped; controlled ] in
  let flags = List.map (fun name -> variable Bool name (Boolean false)) flags in
  let passing = List.map (pass c) (Option.to_list run.clock) in
  let woken = List.concat_map (wake c) (Option.to_list run.clock) in
  let instant = woken @ flags @ before @ stepping in
  results_of_run c run ~drops:(not (String.equal dropped ""))
  @ passing
  @
  match run.active with
  | None -> instant
  | Some active ->
      [ plain (Ir.If { condition = expression c active; then_ = instant; else_ = [] }) ]
