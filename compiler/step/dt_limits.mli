(** Decides which steps limit the times that the caller of the root's step passes.

    The caller's timer may have wrapped around, or its dt may be NaN, so a time must be limited
    before it is used. The root does this, unless only some of the modes of its machine use the
    time. Then these modes limit it, and in all other modes it costs nothing. The same is true of
    nodes that pass a time on without using it. *)

type t

(** How a step limits its dt in seconds. *)
type seconds =
  | Unlimited  (** not at all: the caller has limited dt, or the step's callees do it *)
  | At_most
      (** only at most: the step and its callees use dt only if it is positive, as derivatives do *)
  | Both_ways

val of_program : Ir.program -> t
val seconds : t -> int -> seconds

(** How a step limits its dt in nanoseconds. *)
type nanoseconds =
  | Unlimited
  | To_31_bits  (** if a longer dt has the same effect ({!Short_times.is_dt_short}) *)
  | To_largest  (** to 10^18 *)

val nanoseconds : t -> int -> nanoseconds
