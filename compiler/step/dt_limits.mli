(** Decides which steps limit the times that the caller of the root's step passes.

    The caller's timer may have wrapped around, or its dt may be NaN, so a time must be limited
    before it is used. The root does this, unless only some of the modes of its machine use the
    time. In that case, these modes limit it, so the other modes do not have to spend time on it.
    The same is true of nodes that only pass a time on.

    Some code is safe for every time: a derivative uses dt only if it is positive, and
    [frob_runs_out] accepts every number of nanoseconds ({!Short_times.only_advances}). A step whose
    code is safe does not limit the time. *)

type t

(** How a step limits its dt in seconds. *)
type seconds =
  | Unlimited  (** not at all, because the caller has limited dt *)
  | Where_used
      (** to at most 1e9 s at each use, because the step itself does not use dt, or uses it only if
          it is positive *)
  | Both_ways  (** at its start *)

val of_program : Ir.program -> t
val seconds : t -> int -> seconds

val nanoseconds : t -> int -> bool
(** Whether a step limits its dt in nanoseconds, at its start. *)
