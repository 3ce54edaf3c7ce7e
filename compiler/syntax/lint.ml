open Basis

let broken (span : Span.t) format =
  Format.kasprintf
    (fun message -> Diagnostic.bug ~stage:"Syntax" "%a: %s" Span.pp span message)
    format

let contains (outer : Span.t) (inner : Span.t) =
  let at (p : Span.position) = (Span.line p, Span.column p) in
  String.equal outer.file inner.file
  && compare (at outer.start) (at inner.start) <= 0
  && compare (at inner.stop) (at outer.stop) <= 0
  && compare (at inner.start) (at inner.stop) <= 0

let local (d : Ir.declaration) =
  match d.desc with
  | Signature _ | Binding _ | Claim _ -> ()
  | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Class _ | Instance _ | Primitive _
  | Foreign _ | Parameter _ | Check _ ->
      broken d.span "a declaration that is allowed only at the top level"

let at_least n what span list =
  if List.compare_length_with list n < 0 then broken span "too few %s" what

let tuple span list = if List.compare_length_with list 1 = 0 then broken span "a tuple of one"

let operand ~of_ ~side (e : Ir.expr) =
  match e.desc with
  | Binary { operator; _ } when not (Operators.groups_inside ~outer:of_ ~side operator) ->
      broken e.span "`%s` is not grouped according to the precedence table" operator.name.text
  | _ -> ()

let proc_body span (body : Ir.proc_body) =
  match body with
  | Output { equations; _ } -> List.iter local equations
  | Command _ -> ()
  | Do { statements; result = _ } ->
      let statement (s : Ir.statement) =
        match s with
        | Let_equations ds -> List.iter local ds
        | Bind _ -> ()
        | Bind_expr { span = inner; _ } ->
            if not (contains span inner) then broken inner "a statement outside its proc"
      in
      List.iter statement statements

let expression span (desc : Ir.expr_desc) =
  match desc with
  | Tuple es -> tuple span es
  | Binary { operator; left; right } ->
      operand ~of_:operator ~side:`Left left;
      operand ~of_:operator ~side:`Right right
  | Let { bindings; _ } -> List.iter local bindings
  | Lambda { parameters; _ } -> at_least 1 "parameters" span parameters
  | Record { fields; _ } | Update { fields; _ } -> at_least 1 "fields" span fields
  | Proc { body; _ } -> proc_body span body
  | Sequence { statements; result = _ } ->
      let statement (s : Ir.task_statement) =
        match s with
        | Let_values ds -> List.iter local ds
        | Task { span = inner; _ } ->
            if not (contains span inner) then broken inner "a statement outside its `do`"
      in
      List.iter statement statements
  | Number { digits; _ } ->
      if Exact.of_literal digits = None && String.length digits < 100 then
        broken span "`%s` is not a number" digits
  | Variable _ | Constructor _ | String _ | Array _ | Apply _ | Negate _ | Left_section _
  | Right_section _ | Power _ | If _ | Case _ | Lambda_case _ | Tuple_section _ | Field _
  | Annotated _ | Parenthesized _ ->
      ()

let node (node : Node.t) =
  let span = Node.span node in
  match node with
  | Binding b -> (
      List.iter local b.right.where;
      (match b.left with
      | Function_name { parameters; _ } -> at_least 1 "parameters" span parameters
      | Name _ | Pattern _ -> ());
      match b.right.body with Guarded list -> at_least 1 "guards" span list | Plain _ -> ())
  | Branch b -> (
      List.iter local b.where;
      match b.body with If_guards list -> at_least 1 "guards" span list | Always _ -> ())
  | Expression e -> expression span e.desc
  | Pattern { desc = Tuple_of ps; _ } -> tuple span ps
  | Type { desc = Tuple_type ts; _ } -> tuple span ts
  | Unit { desc = To (_, { numerator; denominator }); _ } ->
      let rec gcd a b = if b = 0 then abs a else gcd b (a mod b) in
      if denominator <= 0 || gcd numerator denominator <> 1 then
        broken span "an exponent that is not in lowest terms"
  | Declaration { desc = Class { members; _ } | Instance { members; _ }; _ } ->
      List.iter local members
  | Declaration _ | Constructor _ | Command _ | Pattern _ | Type _ | Unit _ | Name _ | Qualified _
    ->
      ()

let program (p : Ir.program) =
  let rec walk = function
    | [] -> ()
    | n :: work ->
        node n;
        let outer = Node.span n in
        let add work child =
          let inner = Node.span child in
          if not (contains outer inner) then
            broken inner "lies outside its parent node (%a)" Span.pp outer;
          child :: work
        in
        walk (List.fold_left add work (Node.children n))
  in
  walk (List.rev_map (fun d -> Node.Declaration d) p.declarations)
