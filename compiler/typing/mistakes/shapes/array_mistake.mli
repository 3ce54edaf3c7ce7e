(** Rules for arrays: idioms of other languages, and what to write in Frob. *)

val extreme : Shape_fact.rule
(** [max xs], where [max] takes two values. *)

val computed : Shape_fact.rule
(** An operator on numbers that is applied to an array. *)

val written_as_a_tuple : Shape_fact.rule
(** A tuple where an array is expected. *)

val of_another_size : Shape_fact.rule
(** Two arrays with different numbers of elements. *)

val mapped : Shape_fact.rule
(** [map] for an event or a task, which have counterparts of it, or [mapE] for an array. *)

val of_records : Shape_fact.rule
(** An array of records where one of numbers or truth values is expected. *)

val of_several_types : Shape_fact.rule
(** An array literal with elements of another type than its first. *)

(** {1 For other families} *)

val is_array : Type.t -> bool

val with_each : Shape_fact.t -> string option
(** The function that applies the operator to each element, and its left operand. *)
