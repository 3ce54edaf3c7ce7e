open Basis
open Surface

let rec to_expr (t : term) : Ir.expr =
  let make desc : Ir.expr = { desc; span = t.span } in
  match t.desc with
  | Expression desc -> make desc
  | Variable x -> make (Variable x)
  | Constructor c -> make (Constructor c)
  | Number n -> make (Number n)
  | Negated t -> make (Negate (to_expr t))
  | Tuple ts -> make (Tuple (Long_list.map to_expr ts))
  | Array ts -> make (Array (Long_list.map to_expr ts))
  | Parenthesized t -> make (Parenthesized (to_expr t))
  | Application
      {
        head = { desc = Number { digits; _ }; _ } as number;
        arguments = { desc = Array unit_; span } :: _;
      } ->
      Reject.because (Unit_after_space { number; digits; unit_; at = span })
  | Application { head; arguments } ->
      let apply (f : Ir.expr) argument : Ir.expr =
        let argument = to_expr argument in
        { desc = Apply (f, argument); span = Span.merge f.span argument.span }
      in
      List.fold_left apply (to_expr head) arguments
  | Braces { before; fields } -> (
      let fields = Long_list.map (fun (name, t) -> (name, to_expr t)) fields in
      match before.desc with
      | Constructor constructor -> make (Record { constructor; fields })
      | Expression _ | Wildcard | As _ | Variable _ | Number _ | Negated _ | Tuple _ | Array _
      | Parenthesized _ | Application _ | Braces _ ->
          make (Update { record = to_expr before; fields }))
  | Wildcard -> Reject.because (Wildcard_in_expression t.span)
  | As (name, _) -> Reject.because (As_in_expression { at = t.span; name })

let unqualified (x : Ir.qualified) =
  match x.qualifier with
  | None -> x.name
  | Some q -> Reject.because (Qualified_in_pattern { at = x.span; qualifier = q; name = x.name })

let is_operator (x : Ir.name) =
  match x.text.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> false | _ -> true

let rec to_pattern (t : term) : Ir.pattern =
  let make desc : Ir.pattern = { desc; span = t.span } in
  match t.desc with
  | Wildcard -> make Any
  | Variable x ->
      let name = unqualified x in
      if is_operator name then Reject.because (Operator_bound { at = t.span; operator = name });
      make (Bound name)
  | As (x, t) -> make (As (x, to_pattern t))
  | Constructor c -> make (Constructed (c, []))
  | Number number -> make (Literal { negative = false; number })
  | Negated { desc = Number number; _ } -> make (Literal { negative = true; number })
  | Tuple ts -> make (Tuple_of (Long_list.map to_pattern ts))
  | Array [] -> Reject.because (Empty_array_in_pattern t.span)
  | Array ts -> make (Array_of (Long_list.map to_pattern ts))
  | Parenthesized t -> { (to_pattern t) with span = t.span }
  | Application { head = { desc = Constructor c; _ }; arguments } ->
      make (Constructed (c, Long_list.map to_pattern arguments))
  | Application { head; _ } -> Reject.because (Application_in_pattern head.span)
  | Braces { before = { desc = Constructor c; _ }; fields } ->
      make (Record_of (c, Long_list.map (fun (name, t) -> (name, to_pattern t)) fields))
  | Braces { before; _ } -> Reject.because (Braces_in_pattern before.span)
  | Negated t -> Reject.because (Minus_in_pattern t.span)
  | Expression desc -> Reject.because (Expression_in_pattern { at = t.span; desc })

let rec to_left (t : term) : Ir.left =
  match t.desc with
  | Variable x -> Name (unqualified x)
  | Parenthesized inner -> to_left_inside inner
  | Application { head = { desc = Variable x; _ }; arguments } ->
      Function_name { name = unqualified x; parameters = Long_list.map to_pattern arguments }
  | Expression
      (Binary
         {
           operator = { name = { text = "-"; _ }; _ } as operator;
           left = { desc = Variable a; _ };
           right = { desc = Variable b; _ };
         }) ->
      Reject.because
        (Minus_in_name { at = operator.span; left = unqualified a; right = unqualified b })
  | Expression (Binary { operator; _ }) -> Reject.because (Operator_on_left operator)
  | Application { head = { desc = Parenthesized _; _ } as head; _ } ->
      Reject.because (Parentheses_on_left head.span)
  | Application _ | Expression _ | Wildcard | As _ | Constructor _ | Number _ | Negated _ | Tuple _
  | Array _ | Braces _ ->
      Pattern (to_pattern t)

and to_left_inside (t : term) : Ir.left =
  match t.desc with
  | Variable _ -> to_left t
  | Application _ | Parenthesized _ | Expression _ | Wildcard | As _ | Constructor _ | Number _
  | Negated _ | Tuple _ | Array _ | Braces _ ->
      Pattern (to_pattern t)
