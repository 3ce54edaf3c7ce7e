(** Arguments that were given in another order than the function's.

    Told after all arguments are known: [hold e 0], where [e] is an event, would fit as [hold 0 e].
*)

open Basis

val pair_exchanged :
  unfit:(wanted:Type.t -> Type.t -> bool) -> wanted:Type.t * Type.t -> Type.t * Type.t -> bool
(** The two of a pair do not fit where they stand, and would if they changed places. [unfit]: this
    type fits only as long as nobody asks for its classes. *)

val exchanged :
  unfit:(wanted:Type.t -> Type.t -> bool) ->
  parameters:Type.t list ->
  given:Type.t list ->
  position:int ->
  int option
(** [unfit] as above. [given] are the types of the arguments, of which that at [position], from 1,
    does not fit [parameters], the function's as its scheme has them. The position of another
    argument with which it could change places. *)

val exchange : int -> int -> of_:int -> int list
(** The order of so many arguments in which these two have changed places. *)

val rotated :
  unfit:(wanted:Type.t -> Type.t -> bool) ->
  parameters:Type.t list ->
  given:Type.t list ->
  int list option
(** The order in which three arguments or more fit, if the first was given last, or the last first.
*)

val cure :
  Show.words ->
  name:string ->
  at:Span.t ->
  arguments:Resolve.Ir.expr list ->
  int list ->
  Diagnostic.t ->
  Diagnostic.t
(** The diagnostic of an application, with this in place of its own hints: its arguments in this
    order, each by its position. *)
