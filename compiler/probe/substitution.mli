(** Values of the variables of a polymorphic type. *)

module Ir = Typing.Ir

type t

val empty : t

val matching : Ir.ty -> Ir.ty -> t
(** [matching general specific] returns the substitution that turns [general] into [specific].
    Variables that cannot be determined have no value. *)

val apply : t -> Ir.ty -> Ir.ty
(** Replaces the variables that have values. *)

val without : Ir.variable list -> t -> t
(** Removes the values of these variables. *)

val union : t -> t -> t
(** The values of both substitutions. If both have a value for a variable, the first one takes
    precedence. *)

val data :
  unit_parameters:Ir.variable list ->
  Ir.unit_ list ->
  type_parameters:Ir.variable list ->
  Ir.ty list ->
  t
(** Substitutes the arguments of a data type for the parameters of its declaration. *)

val product : Ir.unit_ list -> Ir.unit_
