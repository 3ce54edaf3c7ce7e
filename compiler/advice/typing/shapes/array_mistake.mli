(** Rules for arrays: idioms of other languages and their equivalents in Frob. *)

open Typing

val extreme : Shape_fact.rule
(** [max xs], where [max] takes two values. *)

val product : Shape_fact.rule
(** A matrix times a vector or a matrix. *)

val computed : Shape_fact.rule
(** A numeric operator applied to an array. *)

val written_as_a_tuple : Shape_fact.rule
(** A tuple where an array is expected. *)

val of_another_size : Shape_fact.rule
(** Two arrays with different numbers of elements. *)

val mapped_over_a_value : Shape_fact.rule
(** [map] applied to a single value. *)

val mapped : Shape_fact.rule
(** [map] applied to an event or a task, for which there are other functions, or [mapE] applied to
    an array. *)

val of_records : Shape_fact.rule
(** An array of records where an array of numbers or [Bool] values is expected. *)

val of_several_types : Shape_fact.rule
(** An array literal with an element whose type differs from that of the first. *)

(** {1 Functions used by other rules} *)

val is_array : Type.t -> bool

val with_each : Shape_fact.t -> string option
(** The two arguments of a [map] that applies the operator to each element: a function, and the left
    operand. *)

val of_one_number : Shape_fact.rule
(** A number in place of an array of numbers, as in [sum v]. *)
