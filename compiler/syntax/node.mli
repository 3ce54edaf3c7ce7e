(** Every part of a program that has a span, and what lies directly in it: for checks that walk
    whole trees without minding what is what. *)

open Basis

type t =
  | Declaration of Ir.declaration
  | Binding of Ir.binding
  | Constructor of Ir.constructor
  | Expression of Ir.expr
  | Branch of Ir.branch
  | Command of Ir.command
  | Pattern of Ir.pattern
  | Type of Ir.ty
  | Unit of Ir.unit_
  | Name of Ir.name
  | Qualified of Ir.qualified

val span : t -> Span.t
val children : t -> t list
val of_right : Ir.right -> t list

val depth_exceeds : int -> t -> Span.t option
(** A place that lies more than so many nodes deep, if there is one. Needs no stack: it is what
    protects the passes that do. *)
