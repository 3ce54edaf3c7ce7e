(** The types of a program, by place in the text. *)

open Basis

type level =
  | Level of Typing.Ir.level
  | Parameter
      (** a parameter of a function, or a variable of a [case] pattern; it has the level of the
          argument or the matched value *)

type local = { scheme : Typing.Ir.scheme; level : level }
type t

val of_program : Typing.Ir.program -> main:string -> t

val type_at : t -> Span.position -> (Span.t * Typing.Ir.ty) option
(** The type of the smallest expression or pattern around this position. *)

val spans_at : t -> Span.position -> Span.t list
(** The spans of all expressions and patterns around this position. *)

val local : t -> Span.t -> local option
(** The local variable or definition that is declared at this place. *)

val global : t -> Resolve.Ir.Global.t -> Typing.Ir.scheme option
(** The type scheme of a definition, if the program uses it. *)

val locals : t -> (Span.t * local) list
val data : t -> Typing.Ir.data list
