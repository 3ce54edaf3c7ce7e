open Basis
open Syntax

let error at format = Diagnostic.error ~code:"E0114" ~at format

(* {1 Expressions} *)

(* The unit in the brackets after a space, if it consists of names, powers, `*` and `/`. *)
let rec unit_text (t : Surface.term) =
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

let unit_after_space ~(number : Surface.term) ~digits ~unit_ (at : Span.t) =
  Diagnostic.error ~code:"E0110" ~at "a unit must directly follow its number, without a space"
  |> Diagnostic.hint "%s"
       (match List.map unit_text unit_ with
       | [ Some measure ] -> Printf.sprintf "remove the space: `%s[%s]`" digits measure
       | _ -> Printf.sprintf "remove the space between `%s` and its unit" digits)
  |> Diagnostic.fix ~safe:true "remove the space"
       [ (Span.make ~file:at.file ~start:number.span.stop ~stop:at.start, "") ]

let wildcard at = error at "`_` is a pattern that matches any value; it cannot be used as a value"

let as_pattern ~at (name : Ir.name) =
  error at "`%s@…` is a pattern and cannot be used in an expression" name.text

(* {1 Patterns} *)

let qualified ~at ~(qualifier : Ir.name) (name : Ir.name) =
  error at "a pattern binds new names, but `%s.%s` belongs to another module" qualifier.text
    name.text

let operator ~at (name : Ir.name) = error at "a pattern cannot bind the operator `%s`" name.text

let empty_array at =
  error at "no array matches `[]`, because every array has at least one element"
  |> Diagnostic.hint "%s" Colon_hint.of_elements

let application at =
  error at "a function cannot be applied in a pattern"
  |> Diagnostic.hint "start the pattern with a constructor, as in `Just x`"

let braces at =
  error at "only a constructor is allowed before the braces of a pattern"
  |> Diagnostic.hint "start a record pattern with a constructor, as in `Pose { heading = h }`"

let no_pattern at what = error at "%s cannot be part of a pattern" what
let minus at = no_pattern at "a minus sign before anything but a number"
let is_comparison operator = List.mem operator [ "<"; ">"; "<="; ">="; "=="; "/="; "&&"; "||" ]

let binary (operator : Ir.qualified) =
  error operator.span "the operator `%s` cannot be part of a pattern" operator.name.text
  |>
  if is_comparison operator.name.text then
    Diagnostic.hint "write the condition as a guard after the pattern: `x | x > 0 -> 1`"
  else Fun.id

let field at (record : Ir.expr) (field : Ir.name) =
  no_pattern at "a field access"
  |> Diagnostic.hint "%s"
       (match record.desc with
       | Variable { name = { text = "self" | "this"; _ }; _ } ->
           Printf.sprintf "Frob has no objects: write only the name, `%s`" field.text
       | Variable { name; _ } ->
           Printf.sprintf
             "Frob has no assignments: make a changed copy with a new name, as in `changed = %s { \
              %s = … }`"
             name.text field.text
       | _ ->
           "Frob has no assignments: make a changed copy with a new name, as in `q = p { x = 1 }`")

let expression at (desc : Ir.expr_desc) =
  match desc with
  | Binary { operator; _ } -> binary operator
  | Power _ -> no_pattern at "a power"
  | String _ -> no_pattern at "a string"
  | If _ -> no_pattern at "an `if`"
  | Case _ -> no_pattern at "a `case`"
  | Let _ -> no_pattern at "a `let`"
  | Lambda _ | Lambda_case _ -> no_pattern at "a function"
  | Tuple_section _ -> no_pattern at "a tuple with missing elements"
  | Proc _ -> no_pattern at "a `proc`"
  | Sequence _ -> no_pattern at "a `do`"
  | Field { record; field = name } -> field at record name
  | Annotated { expr = { desc = Variable { qualifier = None; name; _ }; _ }; _ } ->
      no_pattern at "a type"
      |> Diagnostic.hint
           "write `%s` alone; types belong in a signature, on the line above a definition" name.text
      |> Diagnostic.write at name.text
  | Annotated _ ->
      no_pattern at "a type"
      |> Diagnostic.hint "write the type in a signature, on the line above the definition"
  | Left_section _ | Right_section _ -> no_pattern at "an operator"
  | Apply _ | Update _ | Variable _ | Constructor _ | Number _ | Tuple _ | Array _ | Negate _
  | Record _ | Parenthesized _ ->
      no_pattern at "this expression"

(* {1 Left-hand sides} *)

let minus_in_name ~at ~(left : Ir.name) ~(right : Ir.name) =
  error at "a name cannot contain `-`"
  |> Diagnostic.hint "write `%s`" (left.text ^ String.capitalize_ascii right.text)

let operator_on_left ~text (operator : Ir.qualified) =
  let at = operator.span in
  match Own_operator.built_in_class ~text at with
  | Some (class_, at) -> Built_in_class.instance ~at class_
  | None ->
      error at
        "the left-hand side of a definition cannot contain `%s`: programs cannot define operators"
        operator.name.text
      |> Diagnostic.hint "%s%s"
           (if Own_operator.is_in_an_instance ~text at then "outside the instance, " else "")
           (Own_operator.advice text operator.name.text)

let parentheses_on_left at =
  error at "the left-hand side of a definition must start with the name that it defines"
  |> Diagnostic.hint "remove the parentheses: `f x y = …`"
