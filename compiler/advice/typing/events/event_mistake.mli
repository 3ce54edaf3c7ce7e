(** Rules for an event where another value is expected, or the reverse. *)

open Typing

val is_maybe : Type.t -> bool

val content : Type.t -> Type.t option
(** The type of the value of an event or a [Maybe]. *)

val is_function : Type.t -> bool

val is_an_event : Shape_fact.t -> bool
(** Was an event found? *)

val event_wanted : Shape_fact.t -> bool
(** Was an event expected? *)

val with_default : Shape_fact.t -> string -> string
(** The code for an event in which this value replaces missing values. *)

(** {1 Rules} *)

val merged : Shape_fact.rule
(** `mergeE` with events that carry values of different types. *)

val in_a_maybe : Shape_fact.rule
(** A [Maybe] where its content is expected. *)

val in_place_of_a_number : Shape_fact.rule
(** An event where a number is expected. *)

val mapped_to_a_value : Shape_fact.rule
(** A value in place of the function argument of [mapE]. *)

val of_a_truth : Shape_fact.rule
(** A [Bool] where an event is expected. *)

(** {1 Other messages} *)

val accumulated :
  Wording.t ->
  name:string ->
  at:Basis.Span.t ->
  (Resolve.Ir.expr * Type.t) list ->
  Basis.Diagnostic.t option
(** The message about [accumHold x0 f e], which uses the argument order of other languages. The list
    contains the arguments with their types. *)

val operand : Shape_fact.rule
(** An operator whose left operand is an event, a `Maybe` or a record, and whose right operand is a
    number: reports the left operand, not the number. *)
