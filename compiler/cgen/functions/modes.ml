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

(* For a mode entered in this instant, dt is 0. *)
let forget_time c =
  let set name zero = [ plain (Ir.Assign (Name name, zero)) ] in
  (if c.node.seconds then set "dt" (V.float c.v 0.) else [])
  @ if c.node.nanoseconds then set "dt_ns" (Ir.Integer 0l) else []

(* A chain of [if] statements for the first alternative that holds. *)
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

(* Results need initial values if C compilers cannot see that they are assigned: if results may be
   dropped, they do not know that the first mode always assigns them; if a mode may end early, they
   do not know that another mode follows. *)
let results_of_run c (run : M.run) =
  let ends = List.exists (ends_early c) c.node.modes in
  if (not run.drops) && Option.is_none run.active && not ends then
    List.rev (uninitialized c run.results)
  else List.map (zero c) run.results

(* Calls a mode's step with the places of its results. *)
let step c (mode : M.mode) (case : M.case) results =
  let state = own_state c mode.state in
  let call = step_call c ~node:mode.node ~own:state (for_step c mode.node case.arguments) in
  match results with
  | [ place ] -> plain (Ir.Assign (place, call []))
  | places -> plain (Ir.Do (call (List.map Expression.address places)))

let one_case c (run : M.run) ~again ~dropped k (case : M.case) =
  let mode = List.nth c.node.modes k in
  c.place <- "";
  let results = List.map (fun v -> (v, place c v)) run.results in
  (* If results may be discarded, they are first stored in variables of the case. *)
  let own =
    if not run.drops then []
    else
      List.map
        (fun ((v : M.variable), result) ->
          (v, Name.fresh (Expression.scope c.names) v.name, result))
        results
  in
  let targets =
    if run.drops then List.map (fun (_, name, _) -> Ir.Name name) own else List.map snd results
  in
  let others = List.map (fun v -> (v, Expression.variable c.names v)) case.others in
  let declarations = declared c (List.map (fun (v, name, _) -> (v, name)) own @ others) in
  let call = step c mode case (targets @ List.map named others) in
  let keep =
    match own with
    | [] -> []
    | own ->
        let then_ = List.map (fun (_, name, result) -> plain (Ir.Assign (result, Name name))) own in
        [ plain (Ir.If { condition = Unary (Not, Name dropped); then_; else_ = [] }) ]
  in
  let next (n : M.next) =
    let drop = if n.delayed then [ plain (Ir.Assign (Name dropped, Boolean true)) ] else [] in
    let condition = expression c n.condition in
    (condition, enter c n.entry n.span @ drop @ again, "")
  in
  declarations @ [ call ] @ keep @ first_of (List.map next case.transitions)

let run c (run : M.run) =
  let scope = Expression.scope c.names in
  (* Each iteration runs one mode. There is another iteration if a mode was entered. *)
  let loops = run.steps > 1 in
  let flag name = Name.fresh scope name in
  let steps = if loops then flag "steps" else "" in
  let dropped = if run.drops then flag "dropped" else "" in
  let controlled = if run.late then flag "controlled" else "" in
  let set name value = plain (Ir.Assign (Name name, Boolean value)) in
  let again = if loops then forget_time c @ [ plain Ir.Continue ] else [] in
  let control after (condition, (entry : M.entry)) =
    (expression c condition, enter c entry run.span @ after, "")
  in
  let before =
    if run.late then [] else first_of (List.map (control (forget_time c)) run.controls)
  in
  let after =
    if not run.late then []
    else
      let entering = set controlled true :: set dropped true :: again in
      let alternatives = first_of (List.map (control entering) run.controls) in
      let condition = Ir.Unary (Not, Name controlled) in
      [ plain (Ir.If { condition; then_ = alternatives; else_ = [] }) ]
  in
  let cases =
    List.mapi
      (fun k case ->
        (c.v.nodes.(c.index).modes.(k).constant, one_case c run ~again ~dropped k case))
      run.cases
  in
  let chosen =
    match (running_mode c, cases) with
    | None, [ (_, body) ] -> body
    | Some value, cases -> [ plain (Ir.Switch { value; cases }) ]
    | None, _ -> Diagnostic.bug ~stage:"Cgen.Modes" "modes without a number"
  in
  let stepping =
    if not loops then chosen
    else
      let body = chosen @ after @ [ plain Ir.Break ] in
      [
        plain (Ir.Variable { ty = Int32; name = steps; value = Integer 0l });
        plain (Ir.Repeat { rounds = steps; most = run.steps; body });
      ]
  in
  let wake (clock : M.clock) =
    let since = Expression.field c.names clock.since in
    let seconds = in_seconds c (Name "dt_ns") in
    [ plain (Ir.Assign (Name "dt_ns", since)) ]
    @ (if c.node.seconds then [ plain (Ir.Assign (Name "dt", seconds)) ] else [])
    @ [
        plain (Ir.Assign (since, Integer 0l));
        plain (Ir.Assign (Expression.field c.names clock.running, Boolean true));
      ]
  in
  let pass (clock : M.clock) =
    let since = Expression.field c.names clock.since in
    let running = Expression.field c.names clock.running in
    let then_ = [ plain (Ir.Assign (since, expression c clock.elapsed)) ] in
    plain (Ir.If { condition = running; then_; else_ = [] })
  in
  let passing = List.map pass (Option.to_list run.clock) in
  let woken = List.concat_map wake (Option.to_list run.clock) in
  let variable ty name value = plain (Ir.Variable { ty; name; value }) in
  let flags =
    List.filter_map
      (fun name -> if String.equal name "" then None else Some (variable Bool name (Boolean false)))
      [ dropped; controlled ]
  in
  let instant = woken @ flags @ before @ stepping in
  results_of_run c run @ passing
  @
  match run.active with
  | None -> instant
  | Some active ->
      [ plain (Ir.If { condition = expression c active; then_ = instant; else_ = [] }) ]
