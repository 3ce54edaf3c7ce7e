open Basis
module M = Machine.Ir
module V = Vocabulary

type context = {
  v : V.t;
  names : Expression.names;
  index : int;
  node : M.node;
  write : int -> Ir.expr -> Ir.statement;  (** an output *)
  read : (int, unit) Hashtbl.t;  (** variables that anything reads *)
  mutable place : string;  (** the source line last mentioned *)
}

let plain desc : Ir.statement = { desc; comment = "" }

(* An array of numbers written out. *)
let is_literal : M.expr -> bool = function
  | Elements { elements; _ } ->
      List.for_all (function M.Bool _ | Int _ | Float _ -> true | _ -> false) elements
  | _ -> false

let is_loop (s : Ir.statement) = match s.desc with Ir.For _ -> true | _ -> false

(* Mentions the source line of a statement unless the one before did. *)
let comment c (span : Span.t) =
  let line = span.start.line in
  let place =
    if String.equal span.file c.node.file then Printf.sprintf "line %d" line
    else Printf.sprintf "%s:%d" (Filename.basename span.file) line
  in
  if String.equal place c.place then ""
  else (
    c.place <- place;
    place)

let expression c = Expression.of_machine c.names

(* Declarations without values, one for each run of equal types. *)
let uninitialized c variables =
  let declare groups (variable : M.variable) =
    let ty = V.ty c.v variable.ty and name = Expression.variable c.names variable in
    match groups with
    | (last, names) :: groups when last = ty -> (last, name :: names) :: groups
    | groups -> (ty, [ name ]) :: groups
  in
  List.rev_map
    (fun (ty, names) -> plain (Ir.Variables { ty; names = List.rev names }))
    (List.fold_left declare [] variables)

(* [own]: the address of the state, if there is one. *)
let step_call c ~node ~own arguments results =
  let callee = c.v.program.nodes.(node) in
  let dt = if callee.seconds then [ Ir.Name "dt" ] else [] in
  let dt_ns = if callee.nanoseconds then [ Ir.Name "dt_ns" ] else [] in
  Ir.Call (c.v.nodes.(node).step, List.concat [ own; dt; dt_ns; arguments; results ])

let own_state c state =
  List.map
    (fun field -> Ir.Unary (Ir.Address, Expression.field c.names field))
    (Option.to_list state)

(* Arguments of a node's functions. *)
let for_step c node = Expression.arguments c.names c.v.program.nodes.(node).step.parameters
let for_reset c node = Expression.arguments c.names c.v.program.nodes.(node).reset.parameters

let place c : M.place -> Ir.expr = function
  | Local variable -> Name (Expression.variable c.names variable)
  | Own field -> Expression.field c.names field
  | Result _ -> Diagnostic.bug ~stage:"Cgen.Function" "a result that is read"

let rec statement c rest (s : M.statement) : Ir.statement list =
  (* Statements so far, last first. *)
  match s with
  | Declare { variable; value; span } ->
      let literal = is_literal value in
      let value = expression c value in
      let name = Expression.variable c.names variable and ty = V.ty c.v variable.ty in
      let desc = if literal then Ir.Table { ty; name; value } else Constant { ty; name; value } in
      { desc; comment = comment c span } :: rest
  | Assign { place = Result k; value; span } ->
      { (c.write k (expression c value)) with comment = comment c span } :: rest
  | Assign { place = (Local _ | Own _) as target; value; span } ->
      let target' = place c target in
      let desc =
        match value with
        | Operation { operator = Add; ty = Float; arguments = [ first; amount ] }
          when expression c first = target' ->
            Ir.Add_to (target', expression c amount)
        | value -> Assign (target', expression c value)
      in
      { desc; comment = comment c span } :: rest
  | If { uninitialized = variables; condition; then_; else_; predicted; span } ->
      let declarations = uninitialized c variables in
      let condition = expression c condition in
      let condition =
        (* an update without an alternative stays a branch in any case *)
        if predicted && else_ <> [] then Ir.Call (V.helper c.v Branch, [ condition ])
        else condition
      in
      let comment = comment c span in
      let then_ = statements c then_ in
      let else_ = statements c else_ in
      { desc = If { condition; then_; else_ }; comment } :: List.rev_append declarations rest
  | Step { node; state = Some state; arguments; results; on_trial = true; span } ->
      let name = Name.fresh (Expression.scope c.names) "trial" in
      let value = Expression.field c.names state in
      let copy =
        plain (Ir.Variable { ty = Struct c.v.nodes.(node).state; name; value })
      in
      step c (copy :: rest) ~node ~own:[ Ir.Unary (Address, Name name) ] arguments results span
  | Step { node; state; arguments; results; on_trial = _; span } ->
      step c rest ~node ~own:(own_state c state) arguments results span
  | Reset { node; state; arguments; span } ->
      let own = Expression.field c.names state and arguments = for_reset c node arguments in
      let call own = Ir.Do (Call (c.v.nodes.(node).reset, Unary (Address, own) :: arguments)) in
      let desc =
        match state.content with
        | States_of { count; _ } ->
            let index = Expression.index c.names 0 in
            Ir.For { index; count; body = [ plain (call (Ir.Subscript (own, Name index))) ] }
        | State_of _ | Value _ | Running_mode | Modes _ -> call own
      in
      { desc; comment = comment c span } :: rest
  | Loop l ->
      let own index =
        match l.state with
        | None -> []
        | Some field ->
            [ Ir.Unary (Address, Subscript (Expression.field c.names field, Name index)) ]
      in
      let call index = step_call c ~node:l.node ~own:(own index) in
      let statements = Loop.statements c.names l ~call in
      let comment = comment c l.span in
      List.rev_append (List.map (fun s -> if is_loop s then { s with comment } else s) statements) rest
  | Enter { entry; span } -> List.rev_append (enter c entry span) rest
  | Run run -> List.rev_append (run_modes c run) rest
  | Return { value; span } ->
      { desc = Return (expression c value); comment = comment c span } :: rest

and step c rest ~node ~own arguments results span =
  let arguments = for_step c node arguments in
  let is_read (variable : M.variable) = Hashtbl.mem c.read variable.id in
  match results with
  | [] -> { desc = Do (step_call c ~node ~own arguments []); comment = comment c span } :: rest
  | [ variable ] when not (is_read variable) ->
      { desc = Do (step_call c ~node ~own arguments []); comment = comment c span } :: rest
  | [ variable ] ->
      let value = step_call c ~node ~own arguments [] in
      let name = Expression.variable c.names variable in
      let ty = V.ty c.v variable.ty in
      { desc = Constant { ty; name; value }; comment = comment c span } :: rest
  | variables ->
      let declarations = uninitialized c variables in
      let address variable =
        Ir.Unary (Address, Name (Expression.variable c.names variable))
      in
      let call = step_call c ~node ~own arguments (List.map address variables) in
      { desc = Do call; comment = comment c span } :: List.rev_append declarations rest

and statements c body = List.rev (List.fold_left (statement c) [] body)

(* {1 Machines} *)

and field_with c has =
  List.find_map
    (fun (field : M.field) -> if has field.content then Some (Expression.field c.names field) else None)
    c.node.state

and running_mode c = field_with c (function M.Running_mode -> true | _ -> false)

and enter c (entry : M.entry) span =
  let mode = List.nth c.node.modes entry.mode in
  let comment = comment c span in
  let number =
    match running_mode c with
    | Some place -> [ Ir.Assign (place, Name c.v.nodes.(c.index).modes.(entry.mode).constant) ]
    | None -> []
  in
  let parameter (_, field) value =
    Ir.Assign (Expression.field c.names field, expression c value)
  in
  let parameters = List.map2 parameter mode.parameters entry.parameters in
  let reset =
    match mode.state with
    | None -> []
    | Some state ->
        let own = Ir.Unary (Address, Expression.field c.names state) in
        [ Ir.Do (Call (c.v.nodes.(mode.node).reset, own :: for_reset c mode.node entry.reset)) ]
  in
  match number @ parameters @ reset with
  | [] -> []
  | first :: others -> { Ir.desc = first; comment } :: List.map plain others

(* What a mode enters at its first instant sees no time. *)
and forget_time c =
  (if c.node.seconds then [ plain (Ir.Assign (Name "dt", Float 0.)) ] else [])
  @ if c.node.nanoseconds then [ plain (Ir.Assign (Name "dt_ns", Integer 0l)) ] else []

(* The first alternative that holds. *)
and first_of alternatives =
  List.fold_right
    (fun (condition, then_, comment) else_ ->
      match condition with
      | Ir.Boolean true -> then_
      | condition -> [ { Ir.desc = If { condition; then_; else_ }; comment } ])
    alternatives []

and run_modes c (run : M.run) =
  let scope = Expression.scope c.names in
  let loops = run.steps > 1 in
  let flag name = Name.fresh scope name in
  let steps = flag "steps" and entered = flag "entered" in
  let dropped = if run.drops then flag "dropped" else "" in
  let controlled = if run.late then flag "controlled" else "" in
  let set name value = plain (Ir.Assign (Name name, Boolean value)) in
  let control after (condition, (entry : M.entry)) =
    (expression c condition, enter c entry run.span @ after, "")
  in
  let before =
    if run.late then [] else first_of (List.map (control (forget_time c)) run.controls)
  in
  let after =
    if not run.late then []
    else
      let entering = [ set controlled true; set dropped true; set entered true ] in
      let alternatives = first_of (List.map (control entering) run.controls) in
      let idle = Ir.Unary (Not, Name entered) and once = Ir.Unary (Not, Name controlled) in
      [ plain (Ir.If { condition = Binary (And, idle, once); then_ = alternatives; else_ = [] }) ]
  in
  let cases =
    List.mapi
      (fun k case ->
        (c.v.nodes.(c.index).modes.(k).constant, one_case c run ~loops ~entered ~dropped k case))
      run.cases
  in
  let chosen =
    match (running_mode c, cases) with
    | None, [ (_, body) ] -> body
    | Some value, cases -> [ plain (Ir.Switch { value; cases }) ]
    | None, _ -> Diagnostic.bug ~stage:"Cgen.Function" "modes without a number"
  in
  let stepping =
    if not loops then chosen
    else
      let body =
        (set entered false :: chosen)
        @ after @ forget_time c
        @ [ plain (Ir.Add_to (Name steps, Integer 1l)) ]
      in
      let more = Ir.Binary (Less, Name steps, Integer (Int32.of_int run.steps)) in
      [ plain (Ir.Do_while { body; condition = Binary (And, Name entered, more) }) ]
  in
  let wake (clock : M.clock) =
    let since = Expression.field c.names clock.since in
    let seconds = Ir.Binary (Over, Cast (Real, Name "dt_ns"), Float 1e9) in
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
  let counters =
    if loops then [ variable Int32 steps (Integer 0l); variable Bool entered (Boolean false) ] else []
  in
  let flags =
    List.filter_map
      (fun name -> if String.equal name "" then None else Some (variable Bool name (Boolean false)))
      [ dropped; controlled ]
  in
  let instant = woken @ counters @ flags @ before @ stepping in
  results_of_run c run @ passing
  @
  match run.active with
  | None -> instant
  | Some active ->
      [ plain (Ir.If { condition = expression c active; then_ = instant; else_ = [] }) ]

(* With [drops] C compilers cannot see that the first mode gives values. *)
and results_of_run c (run : M.run) =
  if (not run.drops) && Option.is_none run.active then List.rev (uninitialized c run.results)
  else
    List.map
      (fun (v : M.variable) ->
        let name = Expression.variable c.names v and ty = V.ty c.v v.ty in
        plain (Ir.Variable { ty; name; value = Sum_type.zero c.v.program.sums v.ty }))
      run.results

and one_case c (run : M.run) ~loops ~entered ~dropped k (case : M.case) =
  let mode = List.nth c.node.modes k in
  c.place <- "";
  let arguments = for_step c mode.node case.arguments in
  let results = List.map (fun v -> (v, Expression.variable c.names v)) run.results in
  (* Where results may be dropped they first go to variables of the case. *)
  let own =
    if not run.drops then []
    else
      List.map
        (fun ((v : M.variable), result) ->
          (v, Name.fresh (Expression.scope c.names) result, result))
        results
  in
  let targets =
    if run.drops then List.map (fun (_, name, _) -> name) own else List.map snd results
  in
  let others = List.map (fun v -> (v, Expression.variable c.names v)) case.others in
  let declare (v : M.variable) name = plain (Ir.Variables { ty = V.ty c.v v.ty; names = [ name ] }) in
  let declarations =
    List.map (fun (v, name, _) -> declare v name) own
    @ List.map (fun (v, name) -> declare v name) others
  in
  let all = targets @ List.map snd others in
  let state = own_state c mode.state in
  let call =
    match all with
    | [ name ] ->
        Ir.Assign (Name name, step_call c ~node:mode.node ~own:state arguments [])
    | names ->
        let address name = Ir.Unary (Address, Name name) in
        Ir.Do (step_call c ~node:mode.node ~own:state arguments (List.map address names))
  in
  let keep =
    match own with
    | [] -> []
    | own ->
        let then_ =
          List.map (fun (_, name, result) -> plain (Ir.Assign (Name result, Name name))) own
        in
        [ plain (Ir.If { condition = Unary (Not, Name dropped); then_; else_ = [] }) ]
  in
  let next (n : M.next) =
    let drop = if n.delayed then [ plain (Ir.Assign (Name dropped, Boolean true)) ] else [] in
    let note = if loops then [ plain (Ir.Assign (Name entered, Boolean true)) ] else [] in
    let condition = expression c n.condition in
    (condition, enter c n.entry n.span @ drop @ note, "")
  in
  declarations @ [ plain call ] @ keep @ first_of (List.map next case.transitions)

(* The programmer's names come before the compiler's: [t1] stays [t1]. *)
let name_variables names body =
  let named pass (variable : M.variable) =
    if Bool.equal pass (not (String.equal variable.name "")) then
      ignore (Expression.variable names variable)
  in
  let declared visit =
    Machine.Walk.statements
      (function
        | M.Declare { variable; _ } -> visit variable
        | If { uninitialized; _ } -> List.iter visit uninitialized
        | Step { results; _ } | Loop { results; _ } -> List.iter visit results
        | Run { results; cases; _ } ->
            List.iter visit results;
            List.iter (fun (case : M.case) -> List.iter visit case.others) cases
        | Assign _ | Reset _ | Enter _ | Return _ -> ())
      body
  in
  declared (named true);
  declared (named false)

let variables_read body =
  let read = Hashtbl.create 16 in
  Machine.Walk.expressions
    (function M.Variable v -> Hashtbl.replace read v.id () | _ -> ())
    body;
  read

let reads_state body =
  let found = ref false in
  Machine.Walk.expressions
    (function M.Field _ -> found := true | _ -> ())
    body;
  Machine.Walk.statements
    (function
      | Assign { place = Own _; _ }
      | Step { state = Some _; _ }
      | Loop { state = Some _; _ }
      | Reset _ | Enter _ | Run _ ->
          found := true
      | Declare _ | Assign _ | If _ | Step _ | Loop _ | Return _ -> ())
    body;
  !found

let self v k = (Ir.Pointer (Struct v.V.nodes.(k).state), "self")
let ignored name = plain (Ir.Do (Cast (Void, Name name)))

let place_of (node : M.node) =
  Printf.sprintf "%s, %s:%d" node.origin (Filename.basename node.file) node.span.start.line

let no_result _ _ = Diagnostic.bug ~stage:"Cgen.Function" "a result where there is none"

let parameters (v : V.t) names variables =
  List.map
    (fun (variable : M.variable) ->
      match variable.ty with
      | Array _ ->
          let name = Name.fresh (Expression.scope names) variable.name in
          Expression.read_as names variable (Unary (Dereference, Name name));
          (Ir.Pointer_to_const (V.ty v variable.ty), name)
      | Bool | Int | Float | Sum _ | Nanoseconds ->
          (V.ty v variable.ty, Expression.variable names variable))
    variables

let reset (v : V.t) k : Ir.function_ =
  let node = v.program.nodes.(k) in
  let names = Expression.names v ~node:k in
  let parameters = self v k :: parameters v names node.reset.parameters in
  name_variables names node.reset.body;
  let c = { v; names; index = k; node; write = no_result; read = variables_read node.reset.body; place = "" } in
  let body = statements c node.reset.body in
  let unread = if reads_state node.reset.body then [] else [ ignored "self" ] in
  {
    linkage = (if V.is_root v k then External else Static);
    result = Void;
    name = v.nodes.(k).reset;
    parameters;
    body = List.rev_append (List.rev unread) body;
    comment = place_of node;
  }

(* Few operations: worth a copy at every call. *)
let inline_size = 12

let own_step (v : V.t) k : Ir.function_ =
  let node = v.program.nodes.(k) in
  let names = Expression.names v ~node:k in
  let given = parameters v names node.step.parameters in
  name_variables names node.step.body;
  let single, results =
    match node.outputs with
    | [ (_, ty) ] -> (V.ty v ty, [])
    | outputs ->
        let result (name, ty) =
          (* An unnamed one is [out] or [out.x]. *)
          let name = if List.hd (String.split_on_char '.' name) = "out" then name else "out_" ^ name in
          (Ir.Pointer (V.ty v ty), Name.fresh (Expression.scope names) name)
        in
        (Void, List.map result outputs)
  in
  let places = Array.of_list results in
  let write k value = plain (Ir.Assign (Unary (Dereference, Name (snd places.(k))), value)) in
  let c = { v; names; index = k; node; write; read = variables_read node.step.body; place = "" } in
  let state = if V.has_state v k then [ self v k ] else [] in
  let dt = if node.seconds then [ (Ir.Real, "dt") ] else [] in
  let dt_ns = if node.nanoseconds then [ (Ir.Int64, "dt_ns") ] else [] in
  let unread =
    if V.has_state v k && not (reads_state node.step.body) then [ ignored "self" ] else []
  in
  {
    linkage = (if node.operations <= inline_size then Static_inline else Static);
    result = single;
    name = v.nodes.(k).step;
    parameters = List.concat [ state; dt; dt_ns; given; results ];
    body = List.rev_append (List.rev unread) (statements c node.step.body);
    comment = place_of node;
  }

let no_path () = Diagnostic.bug ~stage:"Cgen.Function" "a place that no path leads to"

(* A place in the input or output, at these indices of the arrays around it. *)
let path from steps indices =
  let step (e, indices) (step : Interface.step) =
    match (step, indices) with
    | Member member, _ -> (Ir.Member (e, member), indices)
    | Element _, index :: others -> (Ir.Subscript (e, index), others)
    | Element _, [] -> no_path ()
  in
  match steps with
  | Interface.Member first :: rest ->
      fst (List.fold_left step (Ir.Arrow (from, first), indices) rest)
  | Element _ :: _ | [] -> no_path ()

(* [body] gets the indices of all arrays around the place. *)
let for_each names steps body =
  let rec around (steps : Interface.step list) indices =
    match steps with
    | [] -> body (List.rev indices)
    | Member _ :: rest -> around rest indices
    | Element count :: rest ->
        let index = Expression.index names (List.length indices) in
        plain (Ir.For { index; count; body = [ around rest (Ir.Name index :: indices) ] })
  in
  around steps []

let is_in_array = List.exists (function Interface.Element _ -> true | Member _ -> false)

(* Between a place in an array of the input or output and a variable. *)
let copy_leaf names steps ~from_interface from own =
  for_each names steps (fun indices ->
      let outside = path from steps indices in
      let own = List.fold_left Array_type.element own indices in
      plain (if from_interface then Ir.Assign (own, outside) else Ir.Assign (outside, own)))

(* dt becomes whole nanoseconds, and 0 where the step cannot know it. *)
let clock c (node : M.node) =
  let rounded () = Ir.Call (V.helper c.v Whole_nanoseconds, [ Name "dt" ]) in
  let at_first zero value =
    match c.v.program.first_instant with
    | Unseen -> value
    | Marked_by field -> Ir.Conditional (Expression.field c.names field, value, zero)
  in
  let seconds_of ns = Ir.Call (V.helper c.v Seconds, [ ns; Name "dt" ]) in
  let times =
    match (node.nanoseconds, node.seconds) with
    | false, false -> []
    | false, true ->
        [ plain (Ir.Assign (Name "dt", at_first (Float 0.) (seconds_of (rounded ())))) ]
    | true, seconds ->
        let value = at_first (Ir.Integer 0l) (Cast (Int64, rounded ())) in
        let name = "dt_ns" in
        (* Where a mode is entered no time has passed. *)
        let ns =
          if node.modes = [] then plain (Ir.Constant { ty = Int64; name; value })
          else plain (Ir.Variable { ty = Int64; name; value })
        in
        let dt () = plain (Ir.Assign (Name "dt", seconds_of (Cast (Real, Name "dt_ns")))) in
        ns :: (if seconds then [ dt () ] else [])
  in
  let mark =
    match c.v.program.first_instant with
    | Unseen -> []
    | Marked_by field ->
        [ plain (Ir.Assign (Expression.field c.names field, Boolean true)) ]
  in
  times @ mark

let dimensions steps =
  List.length (List.filter (function Interface.Element _ -> true | Member _ -> false) steps)

(* Is an array read element by element only, never as a whole? *)
let only_elements_read body (variable : M.variable) ~dimensions =
  let rec is_chain depth (e : M.expr) =
    match e with
    | Variable v -> depth = 0 && v.id = variable.id
    | Index { array; _ } -> is_chain (depth - 1) array
    | _ -> false
  in
  let reads = ref 0 and of_elements = ref 0 in
  Machine.Walk.expressions
    (fun e ->
      (match e with M.Variable v when v.id = variable.id -> incr reads | _ -> ());
      if is_chain dimensions e then incr of_elements)
    body;
  Machine.Walk.statements
    (function
      | M.Loop l ->
          List.iter
            (function
              | M.Each e -> if is_chain (dimensions - 1) e then incr of_elements
              | Accumulated _ | Same _ | Counted _ -> ())
            l.arguments
      | _ -> ())
    body;
  !reads = !of_elements

(* Inputs are read where they are used if their member has a name of its own;
   what is only [f1] there gets the programmer's name first. *)
let inputs c (node : M.node) =
  let direct = Interface.direct c.v.program.input in
  let take (variable : M.variable) members =
    if is_in_array members then
      if not (Hashtbl.mem c.read variable.id) then []
      else if only_elements_read node.step.body variable ~dimensions:(dimensions members) then (
        Expression.read_elements_as c.names variable (path (Name "in") members);
        [])
      else
        let name = Expression.variable c.names variable in
        [
          plain (Ir.Variables { ty = V.ty c.v variable.ty; names = [ name ] });
          copy_leaf c.names members ~from_interface:true (Name "in") (Name name);
        ]
    else
    let read = path (Name "in") members [] in
    if direct || String.equal variable.name "" then (
      Expression.read_as c.names variable read;
      [])
    else if Hashtbl.mem c.read variable.id then
      let ty = V.ty c.v variable.ty in
      let name = Expression.variable c.names variable in
      [ plain (Ir.Constant { ty; name; value = read }) ]
    else []
  in
  List.concat (List.rev (List.rev_map2 take node.step.parameters c.v.input.leaves))

let root_step (v : V.t) k : Ir.function_ =
  let node = v.program.nodes.(k) in
  let names = Expression.names v ~node:k in
  let outputs = Array.of_list v.output.leaves in
  let write k value =
    if is_in_array outputs.(k) then
      copy_leaf names outputs.(k) ~from_interface:false (Name "out") value
    else plain (Ir.Assign (path (Name "out") outputs.(k) [], value))
  in
  let c = { v; names; index = k; node; write; read = variables_read node.step.body; place = "" } in
  let inputs = inputs c node in
  name_variables names node.step.body;
  let clock = clock c node in
  let body = statements c node.step.body in
  let clear steps =
    for_each names steps (fun indices ->
        plain (Ir.Assign (path (Name "out") steps indices, Integer 0l)))
  in
  let unused = List.map clear v.output.unused in
  let reads_self =
    reads_state node.step.body
    || match v.program.first_instant with Marked_by _ -> true | Unseen -> false
  in
  let reads_input =
    List.exists (fun (v : M.variable) -> Hashtbl.mem c.read v.id) node.step.parameters
  in
  let ignore_unless read name = if read then [] else [ ignored name ] in
  {
    linkage = External;
    result = Void;
    name = v.nodes.(k).step;
    parameters =
      [
        self v k;
        (Real, "dt");
        (Pointer_to_const (Struct v.input.struct_name), "in");
        (Pointer (Struct v.output.struct_name), "out");
      ];
    body =
      List.concat
        [
          ignore_unless reads_self "self";
          ignore_unless (node.seconds || node.nanoseconds) "dt";
          ignore_unless reads_input "in";
          clock;
          inputs;
          body;
          unused;
        ];
    comment = place_of node;
  }

let step v k = if V.is_root v k then root_step v k else own_step v k
