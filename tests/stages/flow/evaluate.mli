(** What a Flow program means, evaluated directly: the judge of its passes. *)

open Flow

type value =
  | Bool of bool
  | Int of int32
  | Float of float
  | Sum of int * value list
  | Array of value list

type instant = { dt : float; inputs : value list }

val nan : float
(** A quiet one. *)

val equal : value -> value -> bool
(** Bit for bit, but that all NaN are one. *)

val show : value -> string

val by_demand : Ir.program -> instant list -> value list list
(** The outputs at each instant. Every signal is computed when it is asked for, through instances
    leaf by leaf; needs no schedule. *)

val by_schedule : Ir.program -> instant list -> value list list
(** As the C code does it: each node's reset, then its step in the order of {!Flow.Schedule}, each
    instance one call. Fails on a signal that is read before it is computed. *)
