(** The types of signals as the programmer would write them, with units. *)

type t

val of_program : Typing.Ir.program -> t

val type_of : t -> Catalogue.probe -> Typing.Ir.ty option
(** The type of a signal; for a part of a record or tuple, the type of that part. In a polymorphic
    signal function, the type contains the function's type variables. [None] for signals that the
    compiler introduced. *)

val type_of_signal : t -> name:string -> Basis.Span.t -> Typing.Ir.ty option
(** Like {!type_of}, but for a signal of Flow. [name] includes the path to a leaf; the span is the
    signal's place in the source. *)

val part : t -> Typing.Ir.ty -> string list -> Typing.Ir.ty option
(** The type reached by these fields, components (from 1) and elements ([[0]]), as they appear in a
    column's name. *)

val times_seconds : int -> Typing.Ir.ty -> Typing.Ir.ty
(** [times_seconds k ty]: the type of a number of type [ty] multiplied by the [k]th power of a
    second. *)

val unit_ : Typing.Ir.ty -> string option
(** Unit of a number, or of an event that carries one: [m/s], and [N] instead of [kg m/s^2]. [None]
    if the number is dimensionless, or the unit contains variables. *)
