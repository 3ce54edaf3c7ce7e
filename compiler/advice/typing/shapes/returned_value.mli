(** Equations such as [near d e = return d < e], which use [return] as in C or Python. *)

open Basis

val is_returned : Resolve.Ir.expr -> bool
(** Is this an application of [return]? *)

val diagnostic : Wording.t -> at:Span.t -> Diagnostic.t option
(** The message for a mistake on this line, if the line is an equation whose right-hand side begins
    with [return] and no signature declares the name as a task. *)
