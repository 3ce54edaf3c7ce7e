(** Definitions whose left-hand side contains types, as in C: [Velocity v = 0.3[m/s]] and
    [f (Float x) = …]. *)

open Basis

type advice =
  | Report of Diagnostic.t
  | Reported  (** the error is already reported at another word of the definition *)

val rules : (Unknown.t -> advice option) list

val of_declaration :
  Unknown.t ->
  (string -> Typed_equation.t option) ->
  Proc_signals.c_declaration ->
  Typed_equation.t option
(** Parses the line of the declaration with the given function. Returns the equation if it defines
    the declared name. *)
