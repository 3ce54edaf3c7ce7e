(** Which signals of Flow the programmer wrote as equations of a [proc].

    Flow has names for more: what a branch of a [case] binds has one too, and a value only where
    that branch is taken. *)

open Basis

type t

val of_program : Core.Ir.program -> t

val mem : t -> Span.t -> bool
(** Is it the place where an equation names its signal? *)

val whole : t -> Span.t -> Span.t option
(** The whole equation that names its signal at this place. *)
