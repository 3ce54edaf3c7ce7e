open Basis
module T = Typing.Ir

type place = Every_instant | Elsewhere

(* [equations]: the equations of the enclosing proc, to which instances are added. [name]: the name
   of the nearest enclosing definition. [fall]: the expression to use if all guards of a branch
   fail. *)
type env = {
  ctx : Context.t;
  lifted : Lifting.table;
  scope : Lifting.scope;
  place : place;
  equations : Equations.t option;
  name : string;
  fall : Ir.expr option;
}

let bug format = Diagnostic.bug ~stage:"Core.Of_typed" format
let elsewhere env = { env with place = Elsewhere; fall = None }
let inside env = if env.fall = None then env else { env with fall = None }

let named (p : T.pattern) env =
  match p.desc with
  | Bound local -> { env with name = local.name; fall = None }
  | Any | As _ | Tuple_of _ | Array_of _ | Constructed _ | Literal _ -> inside env

let unary primitive (argument : Ir.expr) span =
  let ty = argument.ty in
  let f = Term.make (Ir.Function (ty, ty)) span (Ir.Primitive (primitive, [ ty ])) in
  Term.apply f argument ty span

let method_of ctx ~class_ ~name ty types : Ir.expr_desc =
  match Instance.find (Context.instances ctx) ~class_ ~name ty types with
  | Some (definition, types) -> Global (definition, types)
  | None -> Method { class_; name; ty; types }

(* The library function [number], with the unit as an additional string argument because Core has no
   units. *)
let number (e : T.expr) =
  let unit_ =
    match e.ty with
    | Function (_, Function (Number (_, { base = []; variables = [] }), _)) -> ""
    | Function (_, Function (Number (_, unit_), _)) -> Typing.Show.unit_ unit_
    | _ -> bug "`number` has an unexpected type"
  in
  let ty = Erasure.ty e.ty in
  let f = Term.make (Ir.Function (String, ty)) e.span (Ir.Global (Signature.reading, [])) in
  Term.apply f (Term.make String e.span (Ir.String unit_)) ty e.span

let rec expr env (e : T.expr) : Ir.expr =
  let make desc = Term.make (Erasure.ty e.ty) e.span desc in
  match e.desc with
  | Local (x, i) -> Lifting.variable env.lifted env.scope e x (Erasure.instantiation i)
  | Global (g, i) -> make (Global (g, Erasure.instantiation i))
  | Primitive ({ module_ = "Display"; name = "number" }, _) -> number e
  | Primitive (g, i) -> make (Primitive (Context.primitive env.ctx g, Erasure.instantiation i))
  | Method { class_; method_; instantiation } -> (
      match Erasure.instantiation instantiation with
      | ty :: types -> make (method_of env.ctx ~class_ ~name:method_.name ty types)
      | [] -> bug "the method `%s` has no class" method_.name)
  | Number value -> make (Number value)
  | String text -> make (String text)
  | Tuple es -> make (Tuple (exprs (inside env) es))
  | Array es -> make (Array (exprs (inside env) es))
  | Index (array, k) -> make (Index (expr (inside env) array, k))
  | Constructor _ | Apply _ -> application (inside env) e []
  | Negate operand -> unary Primitive.Negate (expr (inside env) operand) e.span
  | Power (operand, k) -> unary (Primitive.Power_literal k) (expr (inside env) operand) e.span
  | If (condition, a, b) ->
      let condition = expr (inside env) condition in
      let env = elsewhere env in
      let a = expr env a in
      Term.if_ condition a (expr env b) e.span
  | Case (scrutinee, branches) -> case env e scrutinee branches
  | Let (bindings, body) -> let_ env bindings body
  | Guards (guarded, last) -> guards env guarded last e.span
  | Lambda (patterns, body) -> lambda (elsewhere env) patterns body
  | Proc { input; equations; output } -> proc env e input equations output
  | Run (h, input) -> (
      match env.equations with
      | None -> bug "the instance at %a is not inside a proc" Span.pp e.span
      | Some equations ->
          let binder : Ir.binder =
            { local = Context.fresh env.ctx "" e.span; ty = Erasure.ty e.ty }
          in
          run { env with place = Every_instant } equations binder h input e.span;
          Term.variable binder e.span)
  | Record (c, fields) ->
      let env = inside env in
      let values = Long_list.map (fun (i, value) -> (i, expr env value)) fields in
      let in_order = List.sort (fun (i, _) (j, _) -> Int.compare i j) values in
      make (construct e.ty c (List.map snd in_order))
  | Update (record, c, fields) -> update (inside env) e record c fields
  | Field (record, c, field) ->
      let value = expr (inside env) record in
      make (Payload { value; constructor = c.index; field })

and exprs env es = Long_list.map (expr env) es

and construct (ty : T.ty) (c : T.constructor) arguments : Ir.expr_desc =
  match ty with
  | Bool -> Boolean (c.index = 1)
  | Data { tycon; _ } -> Construct { data = tycon; constructor = c.index; arguments }
  | Variable _ | Number _ | String | Tuple _ | Function _ | Signal_function _ | Size _ ->
      bug "`%s` constructs a value whose type is not a data type" c.constructor.name

(* {2 Application} *)

(* [arguments]: the arguments of the enclosing applications, innermost first, each with the
   application that it belongs to. *)
and application env (e : T.expr) arguments =
  match e.desc with
  | Apply (f, argument) -> application env f ((argument, e) :: arguments)
  | Constructor (c, _) -> saturate env e c arguments
  | _ ->
      List.fold_left
        (fun (f : Ir.expr) (argument, (whole : T.expr)) ->
          (* the result type of [f] is already known *)
          let ty = match f.ty with Function (_, ty) -> ty | _ -> Erasure.ty whole.ty in
          Term.apply f (expr env argument) ty whole.span)
        (expr env e) arguments

(* A constructor used as a function becomes a lambda over its missing fields. *)
and saturate env (e : T.expr) (c : T.constructor) arguments =
  let given = exprs env (List.map fst arguments) in
  let ty, span =
    match List.rev arguments with
    | [] -> (e.ty, e.span)
    | (_, (whole : T.expr)) :: _ -> (whole.ty, whole.span)
  in
  let missing = List.length c.fields - List.length given in
  let rec parameters n (ty : T.ty) newest =
    match ty with
    | Function (a, b) when n > 0 ->
        let binder : Ir.binder = { local = Context.fresh env.ctx "" span; ty = Erasure.ty a } in
        parameters (n - 1) b (binder :: newest)
    | _ when n = 0 -> (ty, newest)
    | _ -> bug "`%s` has too many arguments" c.constructor.name
  in
  let result, newest = parameters missing ty [] in
  let rest = List.rev_map (fun b -> Term.variable b span) newest in
  List.fold_left
    (fun (body : Ir.expr) (b : Ir.binder) ->
      Term.make (Ir.Function (b.ty, body.ty)) span (Ir.Lambda (b, body)))
    (Term.make (Erasure.ty result) span (construct result c (given @ rest)))
    newest

(* {2 Records} *)

and update env (e : T.expr) record c fields =
  let value = expr env record in
  let changed = Int_table.create (List.length fields) in
  let change (i, value) = Int_table.replace changed i (expr env value) in
  List.iter change fields;
  let types = Context.field_types env.ctx value.ty ~constructor:c.index in
  once env value (fun root ->
      let argument field ty =
        match Int_table.find_opt changed field with
        | Some value -> value
        | None -> Term.make ty e.span (Ir.Payload { value = root; constructor = c.index; field })
      in
      Term.make value.ty e.span (construct e.ty c (List.mapi argument types)))

(* Binds a value to a variable, so that it is computed only once even if [use] mentions it several
   times. *)
and once env (value : Ir.expr) use =
  match value.desc with
  | Local _ -> use value
  | _ ->
      let binder : Ir.binder = { local = Context.fresh env.ctx "" value.span; ty = value.ty } in
      Term.let_ binder value (use (Term.variable binder value.span))

(* {2 Choice} *)

and case env (e : T.expr) scrutinee branches =
  let value = expr (inside env) scrutinee in
  let env = elsewhere env in
  let branch (b : T.branch) : Matching.branch =
    {
      pattern = b.pattern;
      falls = falls b.value;
      value = (fun ~fall -> expr { env with fall } b.value);
    }
  in
  let branches = Long_list.map branch branches in
  once env value (fun root -> Matching.case env.ctx ~root e.span branches)

and falls (e : T.expr) =
  match e.desc with Guards (_, None) -> true | Let (_, body) -> falls body | _ -> false

and guards env guarded last span =
  let fall = env.fall in
  let env = elsewhere env in
  let alternatives =
    List.rev_map
      (fun (guard, value) ->
        let guard = expr env guard in
        (guard, expr env value))
      guarded
  in
  let last =
    match (last, fall) with
    | Some last, _ -> expr env last
    | None, Some fall -> fall
    | None, None -> bug "all guards at %a may fail" Span.pp span
  in
  List.fold_left (fun rest (guard, value) -> Term.if_ guard value rest span) last alternatives

(* {2 Binding} *)

and lambda env patterns body =
  let parameters = List.rev_map (fun (p : T.pattern) -> (p, Matching.binder env.ctx p)) patterns in
  List.fold_left
    (fun (body : Ir.expr) ((p : T.pattern), (b : Ir.binder)) ->
      let body =
        List.fold_left
          (fun body (b, value) -> Term.let_ b value body)
          body
          (List.rev (Matching.variables p ~root:(Term.variable b p.span)))
      in
      Term.make (Ir.Function (b.ty, body.ty)) p.span (Ir.Lambda (b, body)))
    (expr env body) parameters

(* The bindings that are not lifted to definitions. The bindings of a [let] inside an equation
   become separate equations. *)
and local_bindings env bindings =
  let at_every_instant = env.place = Every_instant in
  let rec flat (b : T.binding) =
    match b.value.desc with
    | Let (inner, body) -> List.concat_map flat inner @ [ { b with value = body } ]
    | _ -> [ b ]
  in
  let bindings = if at_every_instant then List.concat_map flat bindings else bindings in
  let lifted, others = Lifting.choose env.lifted env.ctx env.scope ~at_every_instant bindings in
  let define (l : Lifting.lifted) =
    let env = { (elsewhere env) with equations = None; scope = l.inside } in
    let env = named l.binding.pattern env in
    Context.define env.ctx (Lifting.definition l (expr env l.binding.value))
  in
  List.iter define lifted;
  others

and let_ env bindings body =
  let bindings = local_bindings env bindings in
  match (env.place, env.equations) with
  | Every_instant, Some equations ->
      List.iter (equation env equations) bindings;
      expr env body
  | _ ->
      let bound newest (b : T.binding) =
        let binder = Matching.binder env.ctx b.pattern in
        let root = Term.variable binder b.pattern.span in
        let parts = Matching.variables b.pattern ~root in
        let value = expr (named b.pattern env) b.value in
        List.rev_append (List.rev parts) ((binder, value) :: newest)
      in
      let newest = List.fold_left bound [] bindings in
      List.fold_left
        (fun (body : Ir.expr) (binder, value) -> Term.let_ binder value body)
        (expr env body) newest

(* {2 Signal functions} *)

and proc env (e : T.expr) input equations output =
  let binder = Matching.binder env.ctx input in
  let mine = Equations.create () in
  Equations.parts mine input ~root:(Term.variable binder input.span) input.span;
  let env = { env with place = Every_instant; equations = Some mine; fall = None } in
  List.iter (equation env mine) (local_bindings env equations);
  let output = expr env output in
  Term.make (Erasure.ty e.ty) e.span
    (Ir.Proc { name = env.name; input = binder; equations = Equations.all mine; output })

(* An instance that is the whole right-hand side does not need an additional variable. *)
and equation env equations (b : T.binding) =
  let binder = Matching.binder env.ctx b.pattern in
  let inner = named b.pattern env in
  (match b.value.desc with
  | Run (h, input) -> run inner equations binder h input b.span
  | _ -> Equations.pure equations binder (expr inner b.value) b.span);
  Equations.parts equations b.pattern ~root:(Term.variable binder b.pattern.span) b.span

and run env equations binder h input span =
  let signal_function = expr (elsewhere env) h in
  let input = expr (inside env) input in
  Equations.run equations binder ~signal_function ~input span

let closed ctx lifted ~(name : Ir.Global.t) types e =
  let scope = Lifting.scope name types in
  expr { ctx; lifted; scope; place = Elsewhere; equations = None; name = name.name; fall = None } e
