(* The message comes from the first rule that applies, so the order defines the priority:

   - A rule for one construct or one function comes before the rule for all values of that type.
   - A rule whose hint is certainly right comes before one that guesses what was meant.
   - The rules for a pair of shapes come before those that depend on why the type is expected (for
     example, in a condition), because the latter accept any type. *)

(* Rules for tasks and signal functions come first: if one of the types is a task or a signal
   function, the structure of the program is usually wrong, whichever other rules also apply. *)
let of_activities =
  [
    Task_mistake.returned;
    Task_mistake.task_or_signal_function;
    Task_mistake.function_of_the_input;
    Task_mistake.statement_without_task;
    Task_mistake.of_an_array;
    Signal_function_mistake.in_place_of_a_test;
    Unrun_mistake.program_without_input;
    Unrun_mistake.program_in_place_of_a_signal_function;
    Truth_mistake.part_of_a_comparison;
    Signal_function_mistake.comparison_without_input;
    Unrun_mistake.unrun;
    Unrun_mistake.unrun_operand;
    Switch_mistake.mode;
    Switch_mistake.input_as_pair;
    Switch_mistake.output_without_event;
    Signal_function_mistake.condition_of_an_event;
    Signal_function_mistake.function_not_lifted;
    Signal_function_mistake.in_place_of_a_function;
  ]

(* Rules for functions where something else is expected. The rules for robot outputs and for
   functions of whole arrays come first, because an additional argument would not help there. *)
let of_functions =
  [
    Conversion_mistake.capital_choice;
    Event_mistake.mapped_to_a_value;
    Output_mistake.statement;
    Output_mistake.twist;
    Output_mistake.not_made;
    Output_mistake.speeds;
    Output_mistake.task_of_a_program;
    Array_mistake.extreme;
    Tuple_mistake.of_more_than_two;
    Tuple_mistake.of_all_arguments;
    Tuple_mistake.mapped_range;
    Tuple_mistake.without_winner;
    Argument_mistake.missing;
    Argument_mistake.more_missing_than_expected;
    Argument_mistake.missing_before;
  ]

(* Rules for values where values of another shape are expected. For an operator or parameter that
   requires numbers, these hints are better than those of the general rules for records, tuples and
   arrays. *)
let of_values =
  [
    Vector_mistake.of_an_operator;
    Array_mistake.product;
    Array_mistake.computed;
    Array_mistake.mapped_over_a_value;
    Signal_function_mistake.conditions;
    Signal_function_mistake.choice;
    Signal_function_mistake.constant;
    Tuple_mistake.selected;
    Event_mistake.operand;
    Record_mistake.compared_with_a_number;
    Tuple_mistake.of_an_input;
    Argument_mistake.lambda_with_too_few_parameters;
    Tuple_mistake.parameter;
    Tuple_mistake.of_another_length;
    Array_mistake.written_as_a_tuple;
    Conversion_mistake.of_seeds;
    Conversion_mistake.of_a_number;
    Record_mistake.in_place_of_a_number;
    Conversion_mistake.of_a_text;
    Tuple_mistake.written_as_an_array;
    Task_mistake.beside_each_other;
    Argument_mistake.missing_in_an_operand;
    Array_mistake.of_another_size;
    Array_mistake.mapped;
    Task_mistake.without_count;
    Task_mistake.only_returned;
    Task_mistake.in_place_of_a_program;
    Task_mistake.in_place_of_its_result;
    Conversion_mistake.by_a_constructor;
    Vector_mistake.of_a_number;
    Record_mistake.built;
    Record_mistake.in_place_of_a_part;
    Array_mistake.of_one_number;
    Tuple_mistake.of_a_function_and_its_argument;
    Switch_mistake.next_mode;
    Array_mistake.of_records;
    Vector_mistake.of_a_tuple;
    Argument_mistake.composed;
    Argument_mistake.one_too_many;
    Tuple_mistake.separated_by_commas;
    Tuple_mistake.of_a_decimal_comma;
  ]

let pattern_of_another_type (fact : Shape_fact.t) =
  match (fact.expected.because, fact.wanted, fact.given) with
  | Value _, Bool, Number _ ->
      Some
        (Shape_fact.not_matched fact
        |> Basis.Diagnostic.hint "match a `Bool` with `True` and `False`, or choose with `if`")
  | Value _, _, _ -> Some (Shape_fact.not_matched fact)
  | _ -> None

(* Rules that depend on the reason for the expected type. A rule for events or enumerations comes
   before the general rule for a condition or a `Bool`. *)
let of_reasons =
  [
    Task_mistake.unlike;
    Event_mistake.merged;
    Event_use.mistake;
    Task_mistake.condition;
    Conversion_mistake.verdict_of_a_truth;
    Conversion_mistake.to_a_choice;
    Truth_mistake.condition;
    Event_mistake.in_a_maybe;
    Event_mistake.in_place_of_a_number;
    Truth_mistake.of_events;
    Event_mistake.of_a_truth;
    Truth_mistake.grouped_with_an_argument;
    Truth_mistake.equal_to_a_truth;
    Truth_mistake.grouped_with_an_operand;
    Truth_mistake.compared;
    Truth_mistake.in_place_of_a_number;
    Array_mistake.of_several_types;
    pattern_of_another_type;
  ]

let rules = of_activities @ of_functions @ of_values @ of_reasons

let shapes words ~subject ~at ~expected ~found =
  let fact = Shape_fact.make words ~subject ~at ~expected ~found in
  Option.value (Shape_fact.first rules fact) ~default:(Shape_fact.different fact)
