open Basis

let missing : Ir.expr_desc = Tuple []
let report env = Context.report_unresolved (Env.context env)

(* Words that begin a statement in other languages. *)
let statements_elsewhere = [ "while"; "for"; "foreach"; "print"; "printf"; "disp"; "fprintf" ]

let rec expr env (e : Syntax.Ir.expr) : Ir.expr =
  match e.desc with
  | Parenthesized inner -> expr env inner
  | _ ->
      Context.nested (Env.context env) e.span
        ~otherwise:({ desc = missing; span = e.span } : Ir.expr)
        (fun () -> { desc = desc env e; span = e.span })

and desc env (e : Syntax.Ir.expr) : Ir.expr_desc =
  let scope = Env.scope env in
  match e.desc with
  | Parenthesized inner -> (expr env inner).desc
  | Variable name -> Option.value (Env.variable env name) ~default:missing
  | Constructor name when Lookup.find_size scope name <> None ->
      let size = Option.get (Lookup.find_size scope name) in
      Number (Patterns.number scope { digits = string_of_int size; decimal = false; unit_ = None })
  | Constructor name -> (
      match Lookup.find scope Interface.constructors name with
      | Some constructor -> Constructor constructor.global
      | None -> missing)
  | Number n -> Number (Patterns.number scope n)
  | String text -> String text
  | Tuple es -> Tuple (Long_list.map (expr env) es)
  | Array es -> Array (Long_list.map (expr env) es)
  | Apply (head, argument) -> (
      match habit_of_another_language env e.span head argument with
      | Some fact ->
          report env fact;
          missing
      | None ->
          let resolved = expr env head in
          if resolved.desc == missing && is_statement_elsewhere head then missing
          else Apply { head = resolved; argument = expr env argument; style = Juxtaposed })
  | Binary { operator; left; right } ->
      let left = expr env left in
      binary env e.span operator left (expr env right)
  | Negate inner -> Negate (expr env inner)
  | Left_section { left; operator } ->
      Apply { head = operator_name env operator; argument = expr env left; style = style operator }
  | Right_section { operator; right } -> right_section env e.span operator right
  | Power { base; exponent } -> Power { base = expr env base; exponent }
  | If { condition; then_; else_ } ->
      let condition = expr env condition in
      let then_ = expr env then_ in
      If { condition; then_; else_ = expr env else_ }
  | Case { scrutinee; branches } ->
      let scrutinee = expr env scrutinee in
      Case { scrutinee; branches = Long_list.map (branch env) branches }
  | Let { bindings; body } ->
      let env, declarations = declarations env bindings in
      Let { declarations; body = expr env body }
  | Tuple_section places -> tuple_section env e.span places
  | Lambda_case branches ->
      let keyword = { e.span with stop = Span.forward 5 e.span.start } in
      function_of env "value" ~at:keyword e.span (fun scrutinee ->
          Ir.Case { scrutinee; branches = Long_list.map (branch env) branches })
  | Lambda { parameters; body } ->
      let env, parameters = Patterns.bind env parameters in
      Lambda { parameters; body = expr env body }
  | Proc { input; body } -> (
      let inner, inputs = Patterns.bind env [ input ] in
      match inputs with
      | [ input ] -> Proc { input; body = proc_body inner body }
      | _ -> Diagnostic.bug ~stage:"Resolve.Expressions" "one pattern became several")
  | Sequence { statements; result } ->
      let statement (env, done_) (s : Syntax.Ir.task_statement) =
        let env, statement = statement env s in
        (env, statement :: done_)
      in
      let env, reversed = List.fold_left statement (env, []) statements in
      Sequence { statements = List.rev reversed; result = expr env result }
  | Record { constructor; fields } -> record env e.span constructor fields
  | Update { record; fields } ->
      let record = expr env record in
      let fields = Long_list.map (fun (name, value) -> (name, expr env value)) fields in
      check_given_once scope (Long_list.map fst fields);
      let candidates =
        Scope.records_with scope (Long_list.map (fun ((n : Syntax.Ir.name), _) -> n.text) fields)
      in
      Update { record; fields; candidates }
  | Field { record; field } ->
      let candidates = Scope.records_with scope [ field.text ] in
      Field { record = expr env record; field; candidates }
  | Annotated { expr = inner; ty } ->
      Annotated { expr = expr env inner; scheme = Types.scheme scope ty }

(* Does this application look like a mistake for something else: a number or value with its unit, or
   a field access? *)
and habit_of_another_language env whole (head : Syntax.Ir.expr) (argument : Syntax.Ir.expr) :
    Fact.unresolved option =
  match (head.desc, argument.desc) with
  | _, (Array [ unit_ ] | Parenthesized unit_) when is_unit_of env head unit_ ->
      Some (Unit_apart { head; unit_; at = argument.span })
  | _, Array [ unit_ ] when head.span.stop = argument.span.start && is_a_unit env unit_ ->
      Some (Unit_of_a_value { head; unit_; at = argument.span })
  | Variable { qualifier = None; name = field; _ }, Variable { qualifier = None; name = record; _ }
    when is_a_field env field && Env.is_known env record ->
      Some (Field_as_function { whole; field; record })
  | _, _ -> None

and head_of (e : Syntax.Ir.expr) =
  match e.desc with Apply (head, _) | Parenthesized head -> head_of head | _ -> e

(* Is this a statement of another language, such as `while (…) …`? If so, its arguments are not
   resolved, because they are in that language, too. *)
and is_statement_elsewhere head =
  match (head_of head).desc with
  | Variable { qualifier = None; name; _ } -> List.mem name.text statements_elsewhere
  | _ -> false

(* Is this a unit separated from its number by a space, as in `f 3 [m/s]`? `m` and `s` must be names
   of units but not of variables. *)
and is_unit_of env (head : Syntax.Ir.expr) unit_ =
  match head.desc with
  | Number { unit_ = None; _ } | Apply (_, { desc = Number { unit_ = None; _ }; _ }) ->
      is_a_unit env unit_
  | _ -> false

and is_a_unit env unit_ =
  let is_unit (name : Syntax.Ir.name) =
    (not (Env.is_known env name)) && Scope.look (Env.scope env) Interface.units name <> None
  in
  Unit_expression.is_unit is_unit unit_

(* Is this the name of a field but not of a variable? *)
and is_a_field env (name : Syntax.Ir.name) =
  (not (Env.is_known env name)) && Scope.records_with (Env.scope env) [ name.text ] <> []

and declarations env bindings =
  Bindings.declarations env ~expr ~command ~items:(Bindings.items bindings)
    ~signatures:(Bindings.signatures bindings)

(* A lambda with one parameter. *)
and function_of env name ~at span body : Ir.expr_desc =
  let local = Context.fresh (Env.context env) name at in
  let body = body ({ desc = Local local; span = at } : Ir.expr) in
  Lambda { parameters = [ { desc = Bound local; span = at } ]; body = { desc = body; span } }

(* Operators *)

and style (operator : Syntax.Ir.qualified) : Ir.apply_style =
  if Interface.is_operator operator.name.text then Operator operator.name.text else Juxtaposed

and operator_name env (operator : Syntax.Ir.qualified) : Ir.expr =
  let desc = Option.value (operator_meaning env operator) ~default:missing in
  { desc; span = operator.span }

(* A name in backticks may be a constructor. *)
and operator_meaning env operator : Ir.expr_desc option =
  match operator.name.text.[0] with
  | 'A' .. 'Z' ->
      Option.map
        (fun (c : Interface.constructor) -> Ir.Constructor c.global)
        (Lookup.find (Env.scope env) Interface.constructors operator)
  | _ -> Env.variable env operator

and binary env span operator (left : Ir.expr) right : Ir.expr_desc =
  let head = operator_name env operator in
  let style = style operator in
  let partial : Ir.expr =
    let span = if left.span = span then span else Span.merge left.span operator.span in
    { desc = Apply { head; argument = left; style }; span }
  in
  Apply { head = partial; argument = right; style }

(* [(- x)] is not a section. [(`f` x)] is a function that takes the first argument of [f]. *)
and right_section env span operator right : Ir.expr_desc =
  function_of env "left" ~at:operator.span span (fun left ->
      binary env span operator left (expr env right))

(* A lambda whose parameters are the missing elements, in order. *)
and tuple_section env span places : Ir.expr_desc =
  let missing = List.filter (( = ) None) places in
  let locals = List.map (fun _ -> Context.fresh (Env.context env) "element" span) missing in
  let place locals element =
    match (element, locals) with
    | Some e, _ -> (locals, expr env e)
    | None, local :: locals -> (locals, ({ desc = Local local; span } : Ir.expr))
    | None, [] -> Diagnostic.bug ~stage:"Resolve.Expressions" "a section without a parameter"
  in
  let _, elements = List.fold_left_map place locals places in
  let parameter local : Ir.pattern = { desc = Bound local; span } in
  Lambda { parameters = List.map parameter locals; body = { desc = Tuple elements; span } }

and command env (c : Syntax.Ir.command) : Ir.expr =
  let head = expr env c.signal_function in
  { desc = Apply { head; argument = expr env c.argument; style = Command }; span = c.span }

(* Branches *)

and branch env (b : Syntax.Ir.branch) : Ir.branch =
  let env, patterns = Patterns.bind env [ b.pattern ] in
  let guards =
    match b.body with
    | Always value -> [ (None, value) ]
    | If_guards guards -> Long_list.map (fun (condition, value) -> (Some condition, value)) guards
  in
  {
    pattern = List.hd patterns;
    right = Bindings.guarded env ~expr ~command ~guards ~where:b.where;
    span = b.span;
  }

(* Procs *)

and proc_body env (body : Syntax.Ir.proc_body) : Ir.proc_body =
  match body with
  | Output { output; equations } ->
      let items = Bindings.equations equations and signatures = Bindings.signatures equations in
      let env, equations = Bindings.declarations env ~expr ~command ~items ~signatures in
      { equations; output = expr env output }
  | Command c -> { equations = { groups = []; signatures = [] }; output = command env c }
  | Do { statements; result } ->
      let items = List.concat_map statement_items statements in
      let signatures = List.concat_map statement_signatures statements in
      let env, equations = Bindings.declarations env ~expr ~command ~items ~signatures in
      { equations; output = command env result }

and statement_items (s : Syntax.Ir.statement) : Bindings.item list =
  match s with
  | Bind { pattern; command } ->
      let span = Span.merge pattern.span command.span in
      [ { left = Pattern pattern; right = Run command; doc = None; span } ]
  | Bind_expr { pattern; expr; span } ->
      let right : Syntax.Ir.right = { body = Plain expr; where = [] } in
      [ { left = Pattern pattern; right = Definition right; doc = None; span } ]
  | Let_equations declarations -> Bindings.equations declarations

and statement_signatures = function
  | Let_equations declarations -> Bindings.signatures declarations
  | Bind _ | Bind_expr _ -> []

(* Tasks *)

and statement env (s : Syntax.Ir.task_statement) : Env.t * Ir.statement =
  match s with
  | Task { pattern = None; task; span = _ } -> (env, Task { pattern = None; task = expr env task })
  | Task { pattern = Some pattern; task; span = _ } ->
      let task = expr env task in
      let env, patterns = Patterns.bind env [ pattern ] in
      (env, Task { pattern = Some (List.hd patterns); task })
  | Let_values bindings ->
      let env, declarations = declarations env bindings in
      (env, Values declarations)

(* Records *)

and check_given_once (scope : Scope.t) names =
  let add seen (name : Syntax.Ir.name) =
    match Interface.String_map.find_opt name.text seen with
    | None -> Interface.String_map.add name.text name seen
    | Some (first : Syntax.Ir.name) ->
        Context.report_record scope.context (Field_set_twice { first; second = name });
        seen
  in
  ignore (List.fold_left add Interface.String_map.empty names)

and record env span constructor fields : Ir.expr_desc =
  let scope = Env.scope env in
  let fields = Long_list.map (fun (name, value) -> (name, expr env value)) fields in
  match Lookup.find scope Interface.constructors constructor with
  | None -> missing
  | Some found -> (
      match Patterns.construction scope found ~at:constructor.span fields with
      | None -> missing
      | Some given ->
          (* an invalid field is probably a misspelling of a missing one, so do not report missing
             fields as well *)
          if List.length given = List.length fields then
            check_complete scope found span given fields;
          Record { constructor = found.global; fields = given })

and check_complete (scope : Scope.t) (constructor : Interface.constructor) span given fields =
  let has =
    Interface.String_set.of_list (Long_list.map (fun ((n : Syntax.Ir.name), _) -> n.text) given)
  in
  let absent =
    List.filter
      (fun field -> not (Interface.String_set.mem field has))
      (Option.value constructor.fields ~default:[])
  in
  match absent with
  | [] -> ()
  | _ ->
      let last = match List.rev fields with (_, (e : Ir.expr)) :: _ -> Some e.span | [] -> None in
      Context.report_record scope.context (Fields_missing { constructor; at = span; absent; last })
