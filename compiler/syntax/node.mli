(** A uniform view of the syntax tree: the nodes that have a span, and their children. Intended for
    checks that treat all kinds of nodes alike. *)

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
(** The place of a node that is nested more deeply than this, if there is one. This function does
    not use the call stack, because it protects the recursive passes from a stack overflow. *)
