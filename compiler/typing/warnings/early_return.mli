(** Warns about a `return` in a [do] that is followed by other statements ([W0312]). It has no
    effect, because only a `return` at the end ends the task. *)

open Basis

val warn : Context.t -> Resolve.Ir.expr -> next:Span.t option -> unit
(** Checks a statement that does not bind anything. [next]: the place of the statement after it. *)

val warn_of_end : Context.t -> Resolve.Ir.expr -> next:Span.t option -> unit
(** Warns if the statement is a task that never ends, because its type promises a result of any type
    ([W0318]). [next]: the statement after it. *)
