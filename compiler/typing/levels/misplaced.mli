(** Reports instances in places that are not evaluated at every instant, and suggests alternatives:
    outside all procs ([E0341]), in branches and guards ([E0342]), in functions ([E0343]). *)

open Basis

(** Is the code at a place evaluated at every instant? *)
type position =
  | Outside  (** outside all procs *)
  | In_task  (** outside all procs, in a [do] *)
  | Every_instant
  | In_branch of condition option  (** the condition, if this is the only enclosing choice *)
  | In_guard
  | In_function of string  (** the function's name; [""] for a lambda *)

and condition = { test : Ir.expr; chosen_if : bool }

(** The reason why the instance cannot simply run at every instant. *)
type obstacle =
  | Depends_on_start
      (** the instance could run at every instant, but the user may have meant it to restart *)
  | Bound_here of Ir.Local.t
      (** the instance mentions this variable, which has no value elsewhere *)
  | Own_definition  (** the instance is part of its own definition *)
  | Lifted
      (** the enclosing function is polymorphic or recursive, so it does not belong to a single proc
      *)

val runs : Ir.expr -> Ir.Global.t -> bool
(** Does this expression run the global, possibly applied to arguments? *)

val name : Ir.expr -> string
(** The name, in messages, of the signal function that the expression runs. *)

val report :
  Diagnostic.sink ->
  Source.t ->
  definition:Ir.Global.t ->
  within:Ir.expr ->
  position ->
  obstacle ->
  Ir.expr ->
  head:Ir.expr ->
  input:Ir.expr ->
  unit
(** Reports an expression that runs the head on the input, in a definition with the value [within].
    The position must not be [Every_instant]. *)
