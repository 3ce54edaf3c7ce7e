(** Counts all instances and state values of a program, including nested ones. Instances of a node
    share its code, so a few lines can create more instances than any memory can hold:
    [s2 = s1 >>> s1], [s3 = s2 >>> s2], … *)

open Basis

val check : Fact.t Facts.t -> entry:Span.t -> Ir.program -> unit
(** Reports a program that has too many instances or too many state values. *)
