(** A direct evaluator of Flow programs. The tests compare the compiler's passes with it. *)

open Flow

type value =
  | Bool of bool
  | Int of int32
  | Float of float
  | Sum of int * value list
  | Array of value list

type instant = { dt : float; inputs : value list }

val nan : float
(** A quiet NaN. *)

val equal : value -> value -> bool
(** Bitwise equality, except that all NaNs are equal. *)

val show : value -> string

val by_demand : Ir.program -> instant list -> value list list
(** The outputs at each instant, without a schedule: computes each signal when it is needed, looking
    through instances output by output. *)

val by_schedule : Ir.program -> instant list -> value list list
(** The outputs at each instant, computed like the C code: each node's reset, then its step in the
    order of {!Flow.Schedule}, with one call for each instance. Fails if a signal is read before it
    is computed. *)
