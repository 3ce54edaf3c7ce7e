(** Explains a mistake in an argument by the application as a whole, such as arguments in the wrong
    order. *)

open Basis
open Context

type mistake = {
  failed : int;  (** the position of the first argument with an error *)
  types : Type.t list;  (** the types of the arguments *)
  of_first : Fact.t Facts.held list;  (** the facts about the first argument *)
  is_only : bool;  (** whether there is only one error *)
}

val tell :
  expressions ->
  t ->
  Resolve.Ir.expr ->
  head:Resolve.Ir.expr ->
  Argument.t list ->
  function_:Type.t ->
  takes:int ->
  mistake ->
  Fact.t Facts.held list ->
  unit
(** Reports the held facts about the arguments. If the application explains the mistake better,
    reports one fact about the whole application in their place. [function_]: the type of the head,
    which takes this number of arguments. *)

val tell_method :
  t -> Resolve.Ir.expr -> head:Resolve.Ir.expr -> Argument.t list -> Fact.t Facts.held list -> unit
(** Reports the held facts about the head. If the head is an array function that is called like a
    method, as in [xs.map f], reports that in place of the last fact. *)
