(** Instances where not every instant looks, and what to write instead: outside of procs ([E0341]),
    in branches and guards ([E0342]), in functions ([E0343]). *)

open Basis

(** Whether what stands here is computed at every instant. *)
type position =
  | Outside  (** of all procs *)
  | In_task  (** likewise, in a [do] *)
  | Every_instant
  | In_branch of condition option  (** of the only choice around *)
  | In_guard
  | In_function of string  (** its name, [""] for a lambda *)

and condition = { test : Ir.expr; chosen_if : bool }

(** Why it cannot run at every instant all the same. *)
type obstacle =
  | Depends_on_start  (** it could, but may not be meant to *)
  | Bound_here of Ir.Local.t  (** this, which it mentions, has no value elsewhere *)
  | Own_definition  (** of which it is a part *)
  | Lifted  (** its function is polymorphic or goes on as itself, so it is of no one proc *)

val runs : Ir.expr -> Ir.Global.t -> bool
(** Is this what is run, perhaps with arguments? *)

val name : Ir.expr -> string
(** What is run, as a message says it. *)

val report :
  Diagnostic.sink ->
  Source.t ->
  position ->
  obstacle ->
  Ir.expr ->
  head:Ir.expr ->
  input:Ir.expr ->
  unit
(** The expression runs the head on the input. The position is not [Every_instant]. *)
