(** Erases units: converts types of Typed to types of Core.

    A representation variable becomes an ordinary type variable. In a list that contains both, types
    come before representations. *)

val ty : Typing.Ir.ty -> Ir.ty
val variable : Typing.Ir.variable -> Ir.variable

val instantiation : Typing.Ir.instantiation -> Ir.ty list
(** The arguments for the {!parameters} of the scheme, in order. *)

val parameters : Typing.Ir.scheme -> Ir.variable list

val boolean : Ir.Global.t
(** The data type [Bool]. Its constructors are constants in Core. *)

val array : Ir.Global.t
(** The data type [Array]. Core's types have a separate case for it. *)

val substitute : (Ir.variable * Ir.ty) list -> Ir.ty -> Ir.ty
(** Replaces variables, compared by [id]. *)
