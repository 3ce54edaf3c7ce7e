(** Prints final types and units in Frob syntax. Messages about inferred types use [Advice.Wording].
*)

val ty : Ir.ty -> string

val scheme : Ir.scheme -> string
(** The type with its context: [Eq a => a -> a -> Bool]. *)

val final_constraint : Ir.class_ -> Ir.ty -> string
(** Prints a constraint, such as [Eq (Maybe Int)]. *)

val unit_ : Ir.unit_ -> string
(** Prints a unit, such as [m/s], [kg m/s^2] or [1]. *)

val class_ : Ir.class_ -> string
