(** Types and units as a programmer would write them. *)

(** {1 What inference found} *)

val ty : Ir.ty -> string

val scheme : Ir.scheme -> string
(** With its context: [Eq a => a -> a -> Bool]. *)

val unit_ : Ir.unit_ -> string
(** [m/s], [kg m/s^2], [1]. *)

(** {1 Types in messages}

    Variables still to be found are named as a programmer would: [a], [b] for
    types, [u], [v] for units, [n] for representations, the same in all texts
    of one message, and apart from the names a signature uses. *)

type words
(** The names given so far in one message. *)

val words : named_unit:(Units.t -> string option) -> words
(** [named_unit] knows units with a name of their own, as [N] for
    [kg m/s^2]. *)

val type_ : words -> Type.t -> string
(** By its alias where it has one. *)

val quoted : words -> Type.t -> string
(** In backticks; a number's alias is followed by the unit, as
    [`Velocity` (m/s)]. *)

val described : words -> Type.t -> string
(** A type in a sentence: quoted, or [a number]. *)

val class_ : Ir.class_ -> string

val constraint_ : words -> Ir.class_ -> Type.t -> string
(** As [Eq (Maybe a)]. *)

val measure : words -> Units.t -> string
val representation : words -> Type.representation -> string
