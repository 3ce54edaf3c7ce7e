(** Determines which signals of Flow the programmer defined by an equation of a [proc].

    Flow also contains other named signals. For example, the variables that a branch of a [case]
    binds have names, but they have values only when that branch is taken. *)

open Basis

type t

val of_program : Core.Ir.program -> t

val mem : t -> Span.t -> bool
(** Whether an equation names its signal at this place. *)

val whole : t -> Span.t -> Span.t option
(** The span of the whole equation that names its signal at this place. *)
