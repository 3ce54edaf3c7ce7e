open Basis
module Ir = Core.Ir

type scope = {
  locals : Value.environment;
  types : Value.substitution;
  node : Node.t;
  owner : string; (* the name to use for anonymous functions *)
  trail : Context.trail;
}

let bug format = Diagnostic.bug ~stage:"Specialize.Expression" format

let position (c : Context.t) s span : Evaluator.position =
  { context = c; trail = s.trail; types = c.types; node = s.node; span }

let closure (c : Context.t) s target code ~name ~span : Value.closure =
  let name =
    match (name, (target : Node.target)) with
    | "", (Unnamed | Defines _ | Named "") -> s.owner
    | "", Named name | name, _ -> name
  in
  let captured = Variables.restrict (Free.of_code c.free (Closure.code_id code)) s.locals in
  { identity = c.fresh (); name; code; captured; types = s.types; span }

let enter (binder : Ir.binder) entry locals = Variables.add binder.local.id entry locals

let bind (binder : Ir.binder) ty value locals =
  enter binder { Value.local = binder.local; local_ty = ty; contents = Known value } locals

(* Expressions so simple that a node for them would not contain any equations. They are evaluated in
   place. *)
let rec is_trivial (e : Ir.expr) =
  match e.desc with
  | Local _ | Number _ | Boolean _ | String _ | Primitive _ | Lambda _ | Proc _ -> true
  | Component (e, _) | Index (e, _) -> is_trivial e
  | Tuple parts | Array parts | Construct { arguments = parts; _ } -> List.for_all is_trivial parts
  | Global _ | Method _ | Apply _ | Let _ | Is_constructor _ | Payload _ | If _ -> false

let number real ty value : Flow.Ir.atom =
  match (ty : Ir.ty) with
  | Int -> (
      match Exact.to_int32 value with
      | Some n -> Int n
      | None -> bug "the Int %s is out of range" (Exact.to_string value))
  | Float -> Float (Real.of_exact real value)
  | Variable _ | Bool | String | Tuple _ | Function _ | Signal_function _ | Data _ | Array _
  | Size _ ->
      bug "a number literal of type %s" (Types.to_string ty)

(* The name of a definition outside the prelude. *)
let own_name (g : Ir.Global.t) = if g.module_ = "Prelude" then None else Some g.name

let bind_types substitution parameters types =
  List.fold_left2
    (fun substitution (v : Ir.variable) ty -> Variables.add v.id ty substitution)
    substitution parameters types

let rec expr (c : Context.t) s target (e : Ir.expr) : Value.t =
  Work.step ();
  match e.desc with
  | Local local -> (
      match Variables.find_opt local.id s.locals with
      | None -> bug "`%s` is not in scope" local.name
      | Some entry -> Closure.forced entry)
  | Global (name, types) ->
      let value = global c s target e name (List.map (Types.close s.types) types) in
      Task.named c ~name:(own_name name) ~at:e.span value
  | Method { class_; name; ty; types } -> (
      let types = List.map (Types.close s.types) types in
      match Core.Instance.find c.instances ~class_ ~name (Types.close s.types ty) types with
      | Some (definition, types) -> global c s target e definition types
      | None -> bug "the method `%s` is used at an open type" name)
  | Primitive (Blank, _) ->
      let result = Types.close s.types e.ty in
      Drawing.apply (position c s e.span) target Blank ~result []
  | Primitive (primitive, types) ->
      let types = List.map (Types.close s.types) types in
      Primitive { primitive; types; arguments = []; owner = s.owner; at = e.span }
  | Number value -> Atom (number c.real (Types.close s.types e.ty) value)
  | Boolean b -> Atom (Bool b)
  | String text -> Text text
  | Lambda (binder, body) ->
      Function (closure c s target (Lambda (binder, body)) ~name:"" ~span:e.span)
  | Proc proc -> Signal_function (closure c s target (Proc proc) ~name:proc.name ~span:e.span)
  | Apply (f, argument) -> spine c s target e f [ argument ]
  | Let { binder; value; body } ->
      let at = value.span in
      let value = expr c s (Named binder.local.name) value in
      let value = Task.named c ~name:(Some binder.local.name) ~at value in
      let ty = Types.close s.types binder.ty in
      expr c { s with locals = bind binder ty value s.locals } target body
  | Tuple parts -> Product (Array.of_list (exprs c s target e parts))
  | Array elements -> Elements (List.map (expr c s Unnamed) elements)
  | Index (array, k) -> element c s target ~span:e.span array k
  | Component (e, index) -> Leaves.component (expr c s Unnamed e) index
  | Construct { data; _ } when Core.Console.is_console data -> Operator.at_rest c
  | Construct { constructor; arguments; data = _ } -> (
      let ty = Types.close s.types e.ty in
      match (Types.layout c.types ty).kind with
      | Product _ -> Product (Array.of_list (exprs c s target e arguments))
      | Scalar | Sum _ | Array _ | Opaque ->
          let arguments = List.map (expr c s Unnamed) arguments in
          Constructed { constructor; arguments })
  | Is_constructor (value, index) ->
      let ty = Types.close s.types value.ty in
      let value = expr c s Unnamed value in
      Atom (Leaves.is_constructor c.types s.node target ~span:e.span ty value index)
  | Payload { value; constructor; field } ->
      let ty = Types.close s.types value.ty in
      let value = expr c s Unnamed value in
      Leaves.payload c.types s.node target ~span:e.span ty value ~constructor ~field
  | If (condition, then_, else_) -> (
      match expr c s Unnamed condition with
      | Atom (Bool true) -> expr c s target then_
      | Atom (Bool false) | Unspecified -> expr c s target else_
      | Atom condition ->
          let then_ = expr c s Unnamed then_ in
          let else_ = expr c s Unnamed else_ in
          let ty = Types.close s.types e.ty in
          Leaves.select c.types s.node target ~span:e.span ty condition then_ else_
      | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Function _ | Signal_function _
      | Primitive _ | Choice _ | Program _ ->
          bug "a condition that is not a Bool")

and element (c : Context.t) s target ~span (array : Ir.expr) k =
  let ty = Types.close s.types array.ty in
  let value = expr c s Unnamed array in
  match ty with
  | Array (Size n, _) when k >= n ->
      Context.report c (Outside { at = span; calls = Context.calls s.trail; index = k; size = n });
      Unspecified
  | _ -> Leaves.element c.types s.node target ~span ty value k

(* Evaluates the components of a product, each with its own target. *)
and exprs (c : Context.t) s target (e : Ir.expr) parts =
  match (target : Node.target) with
  | Unnamed -> List.map (expr c s Unnamed) parts
  | Named _ | Defines _ -> (
      match (Types.layout c.types (Types.close s.types e.ty)).kind with
      | Product layout -> List.map2 (expr c s) (Node.parts target c.types layout) parts
      | Scalar | Sum _ | Array _ | Opaque ->
          bug "a product of type %s, which is not a product type" (Types.to_string e.ty))

and spine (c : Context.t) s target (whole : Ir.expr) (f : Ir.expr) arguments =
  match f.desc with
  | Apply (f, argument) -> spine c s target whole f (argument :: arguments)
  | Local _ | Global _ | Primitive _ | Method _ | Number _ | Boolean _ | String _ | Lambda _ | Let _
  | Tuple _ | Component _ | Array _ | Index _ | Construct _ | Is_constructor _ | Payload _ | If _
  | Proc _ ->
      let function_ = expr c s Unnamed f in
      let name =
        match (f.desc, function_) with
        | Global (g, _), _ -> own_name g
        | _, Function { name; span; _ } ->
            if name = "" || Context.in_prelude c span then None else Some name
        | _ -> None
      in
      let arguments = List.map (argument c s) arguments in
      let result = Types.close s.types whole.ty in
      let value = apply c s target ~span:whole.span ~result function_ arguments in
      Task.named c ~name ~at:whole.span value

and argument (c : Context.t) s (e : Ir.expr) : Value.argument =
  let value = expr c s Unnamed e in
  { value; ty = Types.close s.types e.ty }

(* A definition of first-order type is treated as a function without arguments. Any other definition
   is evaluated where it is used, and only once if it needs no equations. *)
and global (c : Context.t) s target (e : Ir.expr) (name : Ir.Global.t) types =
  match Resolve.Global_table.find_opt c.param_numbers name with
  | None -> definition c s target e name types
  | Some k -> param c s e name k

(* A node reads each parameter only once. *)
and param (c : Context.t) s (e : Ir.expr) (name : Ir.Global.t) k =
  let { Context.code; _ } = Resolve.Global_table.find c.definitions name in
  match (Node.global s.node code, (Types.layout c.types e.ty).leaves) with
  | Some value, _ -> value
  | None, [ { leaf; _ } ] ->
      let atom = Node.define s.node (Named name.name) ~span:e.span leaf (Param k) in
      Node.add_global s.node code (Atom atom);
      Atom atom
  | None, ([] | _ :: _ :: _) -> bug "the parameter `%s` is not a number" name.name

and definition (c : Context.t) s target (e : Ir.expr) (name : Ir.Global.t) types =
  let { Context.core; code } =
    match Resolve.Global_table.find_opt c.definitions name with
    | Some definition -> definition
    | None -> bug "`%s.%s` has no definition" name.module_ name.name
  in
  let inside trail node : scope =
    {
      locals = Variables.empty;
      types = bind_types Variables.empty core.parameters types;
      node;
      owner = name.name;
      trail;
    }
  in
  let trail = Context.enter c s.trail ~name:name.name ~span:e.span in
  let walk = Specialization_key.walk c.keys s.node Holes in
  Specialization_key.add_number walk code;
  List.iter (fun ty -> Specialization_key.add_number walk (Types.layout c.types ty).id) types;
  let key = Specialization_key.key walk in
  let result = Types.close s.types e.ty in
  if (Types.layout c.types result).first_order then
    if is_trivial core.body then expr c (inside trail s.node) target core.body
    else
      Specialization.call c trail s.node target
        {
          kind = Function;
          name = name.name;
          span = core.span;
          call = e.span;
          result;
          statics = [];
          inputs = [];
          names = Destructuring.none;
          key;
        } (fun trail node _ -> expr c (inside trail node) Unnamed core.body)
  else
    match (Variables.Table.find_opt c.globals key, Node.global s.node key) with
    | Some value, _ | None, Some value -> value
    | None, None ->
        let evaluate node =
          let before = Node.size node in
          let trail = if node == s.node then trail else Context.from_here trail in
          let value = expr c (inside trail node) (Named name.name) core.body in
          if Node.size node = before then Variables.Table.replace c.globals key value
          else Node.add_global node key value;
          value
        in
        if Context.nests_deeply c trail && not (Variables.Table.mem c.begun key) then (
          Variables.Table.replace c.begun key ();
          let elsewhere () = ignore (evaluate (Node.create ~fresh:c.fresh)) in
          raise (Context.Postponed elsewhere));
        evaluate s.node

(* [result]: the type after applying all arguments. *)
and apply (c : Context.t) s target ~span ~result (f : Value.t) (arguments : Value.argument list) :
    Value.t =
  match (f, arguments) with
  | _, [] -> f
  | Function ({ code = Lambda (binder, body); captured; _ } as closure), first :: others ->
      apply_lambda c s target ~span ~result closure captured binder body first others
  | Primitive { primitive; types; arguments = before; owner = _; at = _ }, _ -> (
      let all = List.rev_append arguments before in
      let missing = Core.Primitive_table.arity primitive - List.length all in
      match (primitive, all) with
      | Reactimate, [ signal_function ] -> Program signal_function.value
      | Node, [ _; _ ] ->
          Program (Primitive { primitive; types; arguments = all; owner = s.owner; at = span })
      | ( ( Delay | Time | Time_since | Step_time | Ticks | Integral | Derivative | Switch
          | Delayed_switch | Recurring_switch | Delayed_recurring_switch | Initially | On_event
          | Map_sf | Parallel | Make_task | Until_right | Return | Sequence | Run_task | Ending
          | Node
          | Foreign { kind = Stateful; _ } ),
          _ ) ->
          Primitive { primitive; types; arguments = all; owner = s.owner; at = span }
      | _, _ when missing > 0 ->
          Primitive { primitive; types; arguments = all; owner = s.owner; at = span }
      | (At | Length | Replace | Generate | Map | Imap | Zip_with | Foldl | Scanl), _ ->
          on_arrays c s target ~span ~result primitive types (List.rev all)
      | Foreign f, _ -> Foreign_code.apply (position c s span) target f ~result (List.rev all)
      | Console kind, _ -> Operator.apply (position c s span) kind ~result (List.rev all)
      | _, _ -> Operation.apply (position c s span) target primitive ~result (List.rev all))
  | Choice { condition; then_; else_ }, _ ->
      let then_ = apply c s Unnamed ~span ~result then_ arguments in
      let else_ = apply c s Unnamed ~span ~result else_ arguments in
      Leaves.select c.types s.node target ~span result condition then_ else_
  | Unspecified, _ -> Unspecified
  | ( ( Function { code = Proc _; _ }
      | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Signal_function _
      | Program _ ),
      _ ) ->
      bug "an applied value is not a function"

(* Binds the arguments one by one, up to the number of nested lambdas in the code. *)
and apply_lambda (c : Context.t) s target ~span ~result closure locals binder (body : Ir.expr)
    (first : Value.argument) others =
  let locals =
    if Free.uses_binder c.free binder.local.id then bind binder first.ty first.value locals
    else locals
  in
  match (body.desc, others) with
  | Lambda (binder, body), second :: others ->
      apply_lambda c s target ~span ~result closure locals binder body second others
  | _, _ ->
      let applied = { closure with code = Lambda (binder, body); captured = locals } in
      let ty = Types.close closure.types body.ty in
      let whole = match others with [] -> target | _ :: _ -> Node.Unnamed in
      let inside trail =
        { node = s.node; locals; types = closure.types; owner = closure.name; trail }
      in
      let value =
        if not (Types.layout c.types ty).first_order then
          (* the resulting function is named after this function, not after [target] *)
          expr c (inside (Context.enter c s.trail ~name:closure.name ~span)) Unnamed body
        else if is_trivial body then
          expr c (inside (trail_of_trivial c s ~span closure body)) whole body
        else if Operator.is_looked_for c body then
          expr c (inside (Context.enter c s.trail ~name:closure.name ~span)) whole body
        else if first.ty = Tuple [] && others = [] && is_first closure binder then
          join s closure (fun () -> expr c (inside s.trail) Unnamed body)
        else call_function c s whole ~span ~result:ty applied binder body
      in
      apply c s target ~span ~result value others

(* Is this the closure's first parameter? A later parameter belongs to a lambda in the closure's
   body. *)
and is_first (closure : Value.closure) (binder : Ir.binder) =
  match closure.code with Lambda (first, _) -> first.local.id = binder.local.id | _ -> false

(* A trivial body needs a trail only if it indexes an array, because the index may be out of
   range. *)
and trail_of_trivial (c : Context.t) s ~span (closure : Value.closure) (body : Ir.expr) =
  match body.desc with Index _ -> Context.enter c s.trail ~name:closure.name ~span | _ -> s.trail

(* A function with the parameter [()] always returns the same value, so it is evaluated once, in
   place. *)
and join s (closure : Value.closure) evaluate =
  match Node.join s.node closure.identity with
  | Some value -> value
  | None ->
      let value = evaluate () in
      Node.add_join s.node closure.identity value;
      value

(* [applied]: the closure, with its arguments among its captured variables. *)
and call_function (c : Context.t) s target ~span ~result (applied : Value.closure) binder body =
  let trail = Context.enter c s.trail ~name:applied.name ~span in
  let numbers = Specialization_key.numbers_of c.keys applied in
  let walk = Specialization_key.walk c.keys s.node numbers in
  Specialization_key.add_number walk (Closure.code_id applied.code);
  Specialization_key.add_captured walk applied;
  let inputs = Specialization_key.take_holes walk in
  Specialization.call c trail s.node target
    {
      kind = Function;
      name = applied.name;
      span = applied.span;
      call = span;
      result;
      statics = [];
      inputs;
      names = Destructuring.of_lambda c.types applied.types binder body;
      key = Specialization_key.key walk;
    }
    (fun trail node atoms ->
      let locals =
        Specialization_key.captured (Specialization_key.copy c.keys numbers atoms) applied
      in
      expr c { locals; types = applied.types; node; owner = applied.name; trail } Unnamed body)

(* Runs an instance of a signal function. *)
and run (c : Context.t) s target ~span ~result (signal_function : Value.t) (input : Value.argument)
    : Value.t =
  match signal_function with
  | Signal_function ({ code = Proc proc; _ } as closure) ->
      run_proc c s target ~span ~result closure proc input
  | Primitive { primitive = Delay; arguments = [ initial ]; _ } ->
      delay c s target ~span initial input
  | Primitive { primitive = Time; _ } ->
      Atom (Node.define s.node target ~span Float (Time { restart = Bool false }))
  | Primitive { primitive = Time_since; _ } ->
      let restart = Leaves.atom c.types s.node ~span input.ty input.value in
      Atom (Node.define s.node target ~span Float (Time { restart }))
  | Primitive { primitive = Step_time; _ } -> Atom (Node.define s.node target ~span Float Step_time)
  | Primitive { primitive = Ticks; arguments = [ period ]; _ } ->
      let period = Leaves.atom c.types s.node ~span period.ty period.value in
      Atom (Node.define s.node target ~span Bool (Ticks period))
  | Primitive { primitive = Integral; _ } ->
      let input = Leaves.atom c.types s.node ~span input.ty input.value in
      Atom (Node.define s.node target ~span Float (Integral input))
  | Primitive { primitive = Derivative; _ } ->
      let input = Leaves.atom c.types s.node ~span input.ty input.value in
      Atom (Node.define s.node target ~span Float (Derivative input))
  | Primitive { primitive = Map_sf; arguments = [ inner ]; _ } ->
      Arrays.map_sf (position c s span) (evaluator_of_rounds s) target ~result inner input
  | Primitive { primitive = Parallel; arguments = [ all ]; _ } ->
      Arrays.parallel (position c s span) (evaluator_of_rounds s) ~result all input
  | Primitive { primitive = Foreign f; _ } ->
      Foreign_code.apply (position c s span) target f ~result [ input ]
  | Choice _
  | Primitive
      {
        primitive =
          ( Switch | Delayed_switch | Recurring_switch | Delayed_recurring_switch | Initially
          | On_event );
        _;
      } ->
      Machine.run (position c s span) (evaluator s) target ~result signal_function input
  | Primitive { primitive = Run_task; types = [ _; output; ended ]; _ } ->
      run_task c s target ~span ~result ~output ~ended signal_function input
  | Unspecified -> Unspecified
  | Signal_function { code = Lambda _; _ }
  | Atom _ | Text _ | Product _ | Constructed _ | Array _ | Elements _ | Function _ | Primitive _
  | Program _ ->
      bug "the value to run is not a signal function"

(* [Left] with the output, or [Right] with the task's result. *)
and run_task (c : Context.t) s target ~span ~result ~output ~ended signal_function input =
  let parts : Ir.ty = Tuple [ output; Bool; ended ] in
  let value =
    Machine.run (position c s span) (evaluator s) Unnamed ~result:parts signal_function input
  in
  let part = Leaves.component value in
  let left : Value.t = Constructed { constructor = 0; arguments = [ part 0 ] } in
  match part 1 with
  | Atom (Bool false) -> left
  | Atom condition ->
      let right : Value.t = Constructed { constructor = 1; arguments = [ part 2 ] } in
      Leaves.select c.types s.node target ~span result condition right left
  | _ -> bug "the end condition of a task is not a Bool"

(* Applies an array primitive. If the result is a function, applies it to the remaining
   arguments. *)
and on_arrays (c : Context.t) s target ~span ~result primitive types arguments =
  let rec split count (ty : Ir.ty) own (others : Value.argument list) =
    match (ty, others) with
    | Function (_, ty), first :: others when count > 0 -> split (count - 1) ty (first :: own) others
    | _, _ -> (ty, List.rev own, others)
  in
  let arity = Core.Primitive_table.arity primitive in
  match Core.Signature.of_primitive primitive types with
  | None -> bug "`%s` has unexpected type arguments" (Core.Primitive_table.name primitive)
  | Some ty ->
      let own_result, own, others = split arity ty [] arguments in
      let target = if others = [] then target else Node.Unnamed in
      let value =
        Arrays.apply (position c s span) (evaluator_of_rounds s) target primitive ~result:own_result
          own
      in
      apply c s target ~span ~result value others

(* Adds the equations of a proc directly to the position's [node], and evaluates everything else in
   new nodes. *)
and evaluator s : Evaluator.t =
  let scope ({ node; trail; _ } : Evaluator.position) =
    { locals = Variables.empty; types = Variables.empty; node; owner = s.owner; trail }
  in
  {
    run =
      (fun p ~result signal_function input ->
        match signal_function with
        | Signal_function { code = Proc proc; name; captured; types; _ } ->
            let locals = bind proc.input input.ty input.value captured in
            proc_body p.context { (scope p) with locals; types; owner = name } proc
        | _ -> run p.context (scope p) Unnamed ~span:p.span ~result signal_function input);
    apply =
      (fun p ~result f arguments ->
        apply p.context (scope p) Unnamed ~span:p.span ~result f arguments);
    static =
      (fun p { captured = locals; types; name = owner; _ } e ->
        expr p.context { (scope p) with locals; types; owner } Unnamed e);
  }

(* Like {!evaluator}, but for the node of a loop iteration: evaluates functions in that node
   itself. *)
and evaluator_of_rounds s =
  let plain = evaluator s in
  let rec in_place (p : Evaluator.position) ~result (f : Value.t) arguments =
    match (f, (arguments : Value.argument list)) with
    | Function { code = Lambda (binder, body); captured; types; name; _ }, first :: others ->
        let locals = bind binder first.ty first.value captured in
        let inside = { locals; types; node = p.node; owner = name; trail = p.trail } in
        in_place p ~result (expr p.context inside Unnamed body) others
    | _, [] -> f
    | _, _ :: _ -> plain.apply p ~result f arguments
  in
  {
    plain with
    apply = (fun p -> if p.node == s.node then plain.apply p else in_place p);
    run =
      (fun p ~result signal_function input ->
        if p.node == s.node then
          let none = Variables.empty in
          let inside = { s with locals = none; types = Variables.empty; trail = p.trail } in
          run p.context inside Unnamed ~span:p.span ~result signal_function input
        else plain.run p ~result signal_function input);
  }

and delay (c : Context.t) s target ~span (initial : Value.argument) (input : Value.argument) :
    Value.t =
  let layout = Types.layout c.types input.ty in
  if layout.first_order then (
    Context.check_lasting c s.trail ~span
      (List.map (fun (leaf : Types.leaf) -> leaf.leaf) layout.leaves);
    let inits = Leaves.atoms c.types s.node ~span initial.ty initial.value in
    let nexts = Leaves.atoms c.types s.node ~span input.ty input.value in
    let targets = Node.leaves target layout.leaves in
    let one (target, (leaf : Types.leaf)) (init, next) =
      Node.define s.node target ~span leaf.leaf (Delay { init; next })
    in
    Leaves.value c.types input.ty
      (List.map2 one (List.combine targets layout.leaves) (List.combine inits nexts)))
  else (
    Context.report_stored c s.trail ~span input.ty;
    Unspecified)

and run_proc (c : Context.t) s target ~span ~result closure proc input =
  let trail = Context.enter c s.trail ~name:closure.name ~span in
  let is_used = Free.uses_binder c.free proc.input.local.id in
  let numbers = Specialization_key.numbers_of c.keys closure in
  let walk = Specialization_key.walk c.keys s.node numbers in
  Specialization_key.add_number walk (Closure.code_id closure.code);
  Specialization_key.add_captured walk closure;
  let statics = Specialization_key.take_holes walk in
  Context.check_lasting c s.trail ~span (Specialization_key.types statics);
  if is_used then Specialization_key.add walk proc.input.local input.ty input.value;
  let inputs = Specialization_key.take_holes walk in
  Specialization.call c trail s.node target
    {
      kind = Signal_function;
      name = closure.name;
      span = closure.span;
      call = span;
      result;
      statics;
      inputs;
      names = Destructuring.of_proc c.types closure.types proc;
      key = Specialization_key.key walk;
    }
    (fun trail node atoms ->
      let copy = Specialization_key.copy c.keys numbers atoms in
      let locals = Specialization_key.captured copy closure in
      let locals =
        if is_used then
          bind proc.input input.ty (Specialization_key.value copy input.ty input.value) locals
        else locals
      in
      proc_body c { locals; types = closure.types; node; owner = closure.name; trail } proc)

(* Adds the equations of a proc to the node under construction, and returns the output. *)
and proc_body (c : Context.t) s (proc : Ir.proc) : Value.t =
  (* Equations may refer to each other. If Flow can represent the value of an equation, the other
     equations see a signal, which is created in advance. Otherwise, they see a suspension. *)
  let inside = ref s in
  let declare (locals, promises) (eq : Ir.equation) =
    let ty = Types.close s.types eq.binder.ty in
    let { Ir.local; _ } = eq.binder in
    let layout = Types.layout c.types ty in
    let is_constant = Core.Constant_numbers.has c.constants local in
    if layout.first_order && not is_constant then (
      Context.defining c s.trail ty;
      let signals = Node.promise s.node ~name:local.name ~span:local.span layout.leaves in
      let value = Leaves.value c.types ty (List.map (fun s -> Flow.Ir.Signal s) signals) in
      (bind eq.binder ty value locals, (eq, ty, signals) :: promises))
    else
      let evaluate () = equation c !inside (Node.Named local.name) ty eq in
      let entry : Value.entry = { local; local_ty = ty; contents = Suspended evaluate } in
      (enter eq.binder entry locals, promises)
  in
  let locals, promises = List.fold_left declare (s.locals, []) proc.equations in
  inside := { s with locals };
  List.iter
    (fun ((eq : Ir.equation), ty, signals) ->
      let value = equation c !inside (Node.Defines signals) ty eq in
      let atoms = Leaves.atoms c.types s.node ~span:eq.span ty value in
      Node.settle s.node ~span:eq.span signals atoms)
    (List.rev promises);
  expr c !inside Unnamed proc.output

and equation (c : Context.t) s target ty (eq : Ir.equation) =
  match eq.rhs with
  | Pure e -> expr c s target e |> Task.named c ~name:(Some eq.binder.local.name) ~at:e.span
  | Run { signal_function; input } -> (
      let signal_function = expr c s Unnamed signal_function in
      match signal_function with
      | Primitive { primitive = Delay; _ } when not (Types.layout c.types ty).first_order ->
          (* reported before the input is evaluated, because the input may depend on this output *)
          Context.report_stored c s.trail ~span:eq.span ty;
          Unspecified
      | _ -> run c s target ~span:eq.span ~result:ty signal_function (argument c s input))
