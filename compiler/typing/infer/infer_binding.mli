(** Infers bindings: right-hand sides, local declarations, functions.

    Local bindings are generalized only if they are functions with a signature. A local value with a
    polymorphic signature is reported as [E0314]. *)

open Basis
open Context

val is_proc : Resolve.Ir.binding -> bool
(** Is the definition a single [proc], apart from its parameters? *)

val abstraction :
  t ->
  at:Span.t ->
  name:string option ->
  is_proc:bool ->
  Resolve.Ir.pattern list ->
  Expected.t ->
  (Expected.t -> Ir.expr later) ->
  Ir.expr later
(** Checks a function with these parameters; the last argument checks its body. [name]: the name, if
    the function is a definition. [is_proc]: whether the body is a [proc]. Without parameters, the
    result is the body itself. *)

val right : expressions -> t -> Resolve.Ir.right -> Expected.t -> Ir.expr later
(** Checks a right-hand side: its guards and their [where]. *)

val declarations : expressions -> t -> Resolve.Ir.declarations -> Ir.binding list later
(** Checks local declarations. After the call, their names have types. *)

val annotated : expressions -> t -> Resolve.Ir.expr -> Resolve.Ir.expr -> Resolve.Ir.scheme -> typed
(** Infers [(e :: T)], which is treated as a local binding with that signature. *)

val undecided : Expected.t -> bool
(** Is the expected type unconstrained, or a task with an unconstrained result? *)

val beside : undecided:bool -> Expected.t -> Span.t -> Expected.t
(** The expected type for the branches that follow the branch at this place. [undecided]: the result
    of {!undecided} before that branch was checked. *)
