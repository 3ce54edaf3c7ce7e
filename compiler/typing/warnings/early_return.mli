(** Warns about a `return` in a [do] that is followed by other statements ([W0312]). Such a `return`
    has no effect, because only a `return` at the end of the [do] ends the task. *)

open Basis

val warn : Context.t -> Resolve.Ir.expr -> next:Span.t option -> unit
(** Checks a statement that does not bind anything. [next]: the place of the statement after it. *)

val warn_of_end : Context.t -> Resolve.Ir.expr -> next:Span.t option -> unit
(** Warns about a statement that is a task whose result can have any type, because such a task never
    ends ([W0318]). [next]: the place of the statement after it. *)
