(** Equations such as [near d e = return d < e], where [return] was meant as in C or Python. *)

open Basis

val is_returned : Resolve.Ir.expr -> bool
(** Is this an application of [return]? *)

val diagnostic : Wording.t -> at:Span.t -> Diagnostic.t option
(** The message for a mistake on this line, if the line is an equation with [return] after its [=],
    and no signature says that it defines a task. *)
