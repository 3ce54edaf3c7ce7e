(** What types a text has, place by place. *)

open Basis

type level =
  | Level of Typing.Ir.level
  | Parameter  (** of a function: of the level of what it is given *)

type local = { scheme : Typing.Ir.scheme; level : level }
type t

val of_program : Typing.Ir.program -> main:string -> t

val type_at : t -> Span.position -> (Span.t * Typing.Ir.ty) option
(** Of the smallest expression or pattern around it. *)

val spans_at : t -> Span.position -> Span.t list
(** Of all of them. *)

val local : t -> Span.t -> local option
(** Of the variable or definition inside another whose name is declared there. *)

val global : t -> Resolve.Ir.Global.t -> Typing.Ir.scheme option
(** Of those that the program needs. *)

val locals : t -> (Span.t * local) list
val data : t -> Typing.Ir.data list
