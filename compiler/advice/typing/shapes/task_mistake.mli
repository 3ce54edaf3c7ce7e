(** Rules for tasks: a task where a signal function is expected, or the reverse ([E0371]); a
    statement in a [do] that is not a task ([E0370]); a task where a value is expected, and tasks
    whose types differ in one part ([E0301]). *)

val task_or_signal_function : Shape_fact.rule
(** A task where a signal function is expected, or the reverse. *)

val function_of_the_input : Shape_fact.rule
(** A function as a statement, probably meant to be applied to the robot's input. *)

val statement_without_task : Shape_fact.rule
(** A statement in a [do] whose expression is a value, not a task. *)

val of_an_array : Shape_fact.rule
(** An array of tasks in place of a task. *)

val beside_each_other : Shape_fact.rule
(** Tasks combined with a Boolean operator. *)

val in_place_of_a_program : Shape_fact.rule
(** A task used as the program [main]. *)

val in_place_of_its_result : Shape_fact.rule
(** A task where its result is expected. *)

val without_count : Shape_fact.rule
(** A task in place of the number of repetitions. *)

val returned : Shape_fact.rule
(** An equation with [return] before its value, such as [near d e = return d < e]. *)

val only_returned : Shape_fact.rule
(** [return x] as the value of a function or an equation. *)

val condition : Shape_fact.rule
(** A task as the condition of an [if]. *)

val unlike : Shape_fact.rule
(** Two tasks that differ only in their inputs, only in their outputs or only in their results. *)
