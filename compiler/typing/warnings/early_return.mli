(** [W0312] a `return` among the statements of a [do], which others follow: it does nothing, as it
    ends the task only where it is the last. *)

open Basis

val warn : Context.t -> Resolve.Ir.expr -> next:Span.t option -> unit
(** Of a statement that binds nothing; [next] is where the one after it stands. *)
