(** Types without their units: what is left of a Typed type in Core.

    A representation variable becomes a type variable like any other; where both stand in one list,
    types come before representations. *)

val ty : Typing.Ir.ty -> Ir.ty
val variable : Typing.Ir.variable -> Ir.variable

val instantiation : Typing.Ir.instantiation -> Ir.ty list
(** For {!parameters} of the scheme, in order. *)

val parameters : Typing.Ir.scheme -> Ir.variable list

val boolean : Ir.Global.t
(** The data type [Bool], whose constructors are constants in Core. *)

val array : Ir.Global.t
(** The data type [Array], a type of its own in Core. *)

val substitute : (Ir.variable * Ir.ty) list -> Ir.ty -> Ir.ty
(** Variables by their [id]. *)
