(** Recognizes arguments given in the wrong order.

    For example, [hold e 0], where [e] is an event, would be correct as [hold 0 e]. Call these
    functions when the types of all arguments are known. *)

val parameters : Type.t -> Type.t list
(** The types of a function's parameters, including the input of a signal function that it returns.
*)

val pair_exchanged :
  unfit:(wanted:Type.t -> Type.t -> bool) -> wanted:Type.t * Type.t -> Type.t * Type.t -> bool
(** Would this pair, whose type is wrong, be correct with its components swapped? [unfit]: whether
    the given type lacks a class that the expected type must have. *)

val exchanged :
  unfit:(wanted:Type.t -> Type.t -> bool) ->
  parameters:Type.t list ->
  given:Type.t list ->
  position:int ->
  int option
(** The position of an argument that could be swapped with the argument at [position], whose type is
    wrong. Both positions are counted from 1. [given]: the types of the arguments. [parameters]: the
    parameter types from the function's scheme. [unfit]: see {!pair_exchanged}. *)

val may_be : wanted:Type.t -> Type.t -> bool
(** Could an argument of this type be intended where [wanted] is expected? *)

val rotated :
  unfit:(wanted:Type.t -> Type.t -> bool) ->
  parameters:Type.t list ->
  given:Type.t list ->
  int list option
(** If there are at least three arguments, and the first was given last or the last was given first,
    the order in which they fit. *)

val shifted :
  unfit:(wanted:Type.t -> Type.t -> bool) ->
  is_constrained:(Type.t -> bool) ->
  parameters:Type.t list ->
  given:Type.t list ->
  position:int ->
  int option
(** The number of missing arguments, if the argument at [position] and those after it fit the last
    parameters, and those before it fit the first ones. [is_constrained]: whether a type variable
    has a class constraint. *)
