open Basis
open Surface

(* The unit in the brackets after a space, if it is made of names, `*` and `/`. *)
let rec unit_text (t : term) =
  let rec of_expr : Ir.expr_desc -> string option = function
    | Variable { qualifier = None; name; _ } -> Some name.text
    | Binary { operator = { name = { text = ("*" | "/") as op; _ }; _ }; left; right } -> (
        match (of_expr left.desc, of_expr right.desc) with
        | Some left, Some right -> Some (left ^ op ^ right)
        | _ -> None)
    | Power { base; exponent } ->
        Option.map (fun b -> Printf.sprintf "%s^%d" b exponent) (of_expr base.desc)
    | _ -> None
  in
  match t.desc with
  | Variable { qualifier = None; name; _ } -> Some name.text
  | Expression desc -> of_expr desc
  | Parenthesized t -> unit_text t
  | _ -> None

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
        head = { desc = Number { digits; _ }; _ } as head;
        arguments = { desc = Array elements; span } :: _;
      } ->
      let hint =
        match List.map unit_text elements with
        | [ Some measure ] -> Printf.sprintf "remove the space: `%s[%s]`" digits measure
        | _ -> Printf.sprintf "remove the space between `%s` and its unit" digits
      in
      Reject.diagnostic
        (Diagnostic.error ~code:"E0110" ~at:span
           "a unit must directly follow its number, without a space"
        |> Diagnostic.hint hint
        |> Diagnostic.fix ~safe:true "remove the space"
             [ (Span.make ~file:span.file ~start:head.span.stop ~stop:span.start, "") ])
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
  | Wildcard ->
      Reject.at ~code:"E0114" t.span
        "`_` is a pattern that matches any value; it cannot be used as a value"
  | As (x, _) ->
      Reject.at ~code:"E0114" t.span "`%s@…` is a pattern and cannot be used in an expression"
        x.text

let no_pattern span what = Reject.at ~code:"E0114" span "%s cannot be part of a pattern" what

let unqualified (x : Ir.qualified) =
  match x.qualifier with
  | None -> x.name
  | Some q ->
      Reject.at ~code:"E0114" x.span
        "a pattern binds new names, but `%s.%s` belongs to another module" q.text x.name.text

let is_operator (x : Ir.name) =
  match x.text.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> false | _ -> true

let of_comparison = function
  | "<" | ">" | "<=" | ">=" | "==" | "/=" | "&&" | "||" ->
      Some "write the condition as a guard after the pattern: `x | x > 0 -> 1`"
  | _ -> None

let rec to_pattern (t : term) : Ir.pattern =
  let make desc : Ir.pattern = { desc; span = t.span } in
  match t.desc with
  | Wildcard -> make Any
  | Variable x ->
      let name = unqualified x in
      if is_operator name then
        Reject.at ~code:"E0114" t.span "a pattern cannot bind the operator `%s`" name.text;
      make (Bound name)
  | As (x, t) -> make (As (x, to_pattern t))
  | Constructor c -> make (Constructed (c, []))
  | Number number -> make (Literal { negative = false; number })
  | Negated { desc = Number number; _ } -> make (Literal { negative = true; number })
  | Tuple ts -> make (Tuple_of (Long_list.map to_pattern ts))
  | Array [] ->
      Reject.at ~code:"E0114" t.span ~hint:Character_hint.of_elements
        "no array matches `[]`, because every array has at least one element"
  | Array ts -> make (Array_of (Long_list.map to_pattern ts))
  | Parenthesized t -> { (to_pattern t) with span = t.span }
  | Application { head = { desc = Constructor c; _ }; arguments } ->
      make (Constructed (c, Long_list.map to_pattern arguments))
  | Application { head; _ } ->
      Reject.at ~code:"E0114" head.span ~hint:"start the pattern with a constructor, as in `Just x`"
        "a function cannot be applied in a pattern"
  | Braces { before = { desc = Constructor c; _ }; fields } ->
      make (Record_of (c, Long_list.map (fun (name, t) -> (name, to_pattern t)) fields))
  | Braces { before; _ } ->
      Reject.at ~code:"E0114" before.span
        ~hint:"start a record pattern with a constructor, as in `Pose { heading = h }`"
        "only a constructor is allowed before the braces of a pattern"
  | Negated t -> no_pattern t.span "a minus sign before anything but a number"
  | Expression desc -> no_expression t.span desc

and no_expression span (desc : Ir.expr_desc) =
  match desc with
  | Binary { operator; _ } ->
      Reject.at ~code:"E0114" operator.span
        ?hint:(of_comparison operator.name.text)
        "the operator `%s` cannot be part of a pattern" operator.name.text
  | Power _ -> no_pattern span "a power"
  | String _ -> no_pattern span "a text"
  | If _ -> no_pattern span "an `if`"
  | Case _ -> no_pattern span "a `case`"
  | Let _ -> no_pattern span "a `let`"
  | Lambda _ | Lambda_case _ -> no_pattern span "a function"
  | Tuple_section _ -> no_pattern span "a tuple without some of its elements"
  | Proc _ -> no_pattern span "a `proc`"
  | Sequence _ -> no_pattern span "a `do`"
  | Field { record = { desc = Variable { name = { text = "self" | "this"; _ }; _ }; _ }; field } ->
      Reject.at ~code:"E0114" span
        ~hint:(Printf.sprintf "Frob has no objects: write only the name, `%s`" field.text)
        "a field access cannot be part of a pattern"
  | Field { record = { desc = Variable { name; _ }; _ }; field } ->
      Reject.at ~code:"E0114" span
        ~hint:
          (Printf.sprintf
             "Frob has no assignments: give a changed copy a new name, as in `changed = %s { %s = \
              … }`"
             name.text field.text)
        "a field access cannot be part of a pattern"
  | Field _ ->
      Reject.at ~code:"E0114" span
        ~hint:"Frob has no assignments: give a changed copy a new name, as in `q = p { x = 1 }`"
        "a field access cannot be part of a pattern"
  | Annotated _ ->
      Reject.at ~code:"E0114" span
        ~hint:"write the type in a signature, on the line above the definition"
        "a type cannot be part of a pattern"
  | Left_section _ | Right_section _ -> no_pattern span "an operator"
  | Apply _ | Update _ | Variable _ | Constructor _ | Number _ | Tuple _ | Array _ | Negate _
  | Record _ | Parenthesized _ ->
      no_pattern span "this expression"

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
      Reject.at ~code:"E0114" operator.span
        ~hint:
          (Printf.sprintf "write `%s`"
             ((unqualified a).text ^ String.capitalize_ascii (unqualified b).text))
        "a name cannot contain `-`"
  | Expression (Binary { operator; _ }) ->
      Reject.at ~code:"E0114" operator.span
        ~hint:"define a function of two arguments, and use it infix in backticks"
        "the left side of a definition cannot contain `%s`: programs cannot define operators"
        operator.name.text
  | Application { head = { desc = Parenthesized _; _ } as head; _ } ->
      Reject.at ~code:"E0114" head.span ~hint:"remove the parentheses: `f x y = …`"
        "the left side of a definition must start with the name that it defines"
  | Application _ | Expression _ | Wildcard | As _ | Constructor _ | Number _ | Negated _ | Tuple _
  | Array _ | Braces _ ->
      Pattern (to_pattern t)

and to_left_inside (t : term) : Ir.left =
  match t.desc with
  | Variable _ -> to_left t
  | Application _ | Parenthesized _ | Expression _ | Wildcard | As _ | Constructor _ | Number _
  | Negated _ | Tuple _ | Array _ | Braces _ ->
      Pattern (to_pattern t)
