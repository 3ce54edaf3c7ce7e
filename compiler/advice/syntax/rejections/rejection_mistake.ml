let diagnostic ~text (reason : Syntax.Rejection.t) =
  match reason with
  | Context_without_classes at -> Form_mistake.context at
  | Class_head at -> Form_mistake.class_head at
  | Superclass_of_other_type { at; class_; variable } ->
      Form_mistake.superclass ~at ~class_ variable
  | Instance_head at -> Form_mistake.instance_head at
  | Foreign_word { expected; found } -> Form_mistake.foreign_word ~expected found
  | Size_not_whole { at; digits } -> Form_mistake.size ~at digits
  | Size_operator { at; operator } -> Form_mistake.size_operator ~text ~at operator
  | Number_in_unit { at; digits } -> Form_mistake.number_in_unit ~text ~at digits
  | Exponent_not_whole { at; digits } -> Form_mistake.exponent_not_whole ~at digits
  | Exponent_too_large at -> Form_mistake.exponent_too_large at
  | Exponent_over_zero at -> Form_mistake.exponent_over_zero at
  | Scale_of_unit at -> Form_mistake.scale at
  | Expression_in_proc { expr; is_last } -> Statement_mistake.in_proc ~is_last expr
  | Output_binds { at; name } -> Statement_mistake.output_binds ~at name
  | Output_is_let { at; name } -> Statement_mistake.output_is_let ~at name
  | Empty_proc at -> Statement_mistake.empty_proc at
  | Last_task_binds { at; name } -> Statement_mistake.last_task_binds ~at name
  | Last_task_is_let at -> Statement_mistake.last_task_is_let at
  | Empty_task at -> Statement_mistake.empty_task at
  | Rec_in_task at -> Statement_mistake.rec_in_task at
  | Empty_where at -> Form_mistake.empty_where at
  | Several_clauses { first; second; others } -> Clause_mistake.diagnostic first second others
  | Unit_after_space { number; digits; unit_; at } ->
      Term_mistake.unit_after_space ~number ~digits ~unit_ at
  | Wildcard_in_expression at -> Term_mistake.wildcard at
  | As_in_expression { at; name } -> Term_mistake.as_pattern ~at name
  | Qualified_in_pattern { at; qualifier; name } -> Term_mistake.qualified ~at ~qualifier name
  | Operator_bound { at; operator } -> Term_mistake.operator ~at operator
  | Empty_array_in_pattern at -> Term_mistake.empty_array at
  | Application_in_pattern at -> Term_mistake.application at
  | Braces_in_pattern at -> Term_mistake.braces at
  | Minus_in_pattern at -> Term_mistake.minus at
  | Expression_in_pattern { at; desc } -> Term_mistake.expression at desc
  | Minus_in_name { at; left; right } -> Term_mistake.minus_in_name ~at ~left ~right
  | Operator_on_left operator -> Term_mistake.operator_on_left ~text operator
  | Parentheses_on_left at -> Term_mistake.parentheses_on_left at
  | Exponent { base; operator; exponent } ->
      Operator_mistake.exponent ~text ~base ~operator exponent
  | Two_operators { left; first; middle; second; right; compare } ->
      Operator_mistake.two_operators ~text ~compare left first middle second right
  | Minus_after { operator; at; operand } -> Operator_mistake.minus_after ~operator ~at operand
  | Two_minuses { first; second; operand } -> Operator_mistake.two_minuses ~first ~second operand
  | Section { operator; inner } -> Operator_mistake.section operator ~inner
