(** Decides which steps limit the times that the caller of the root's step passes.

    The caller's timer may have wrapped around, or its dt may be NaN, so a time must be limited
    before it is used. The root does this, unless only some of the modes of its machine use the
    time. Then these modes limit it, and in all other modes it costs nothing. The same is true of
    nodes that pass a time on without using it.

    Some code is safe for every time: a derivative uses dt only if it is positive, and
    [frob_runs_out] accepts every number of nanoseconds ({!Short_times.only_advances}). A step whose
    code is safe does not limit the time. *)

type t

(** How a step limits its dt in seconds. *)
type seconds =
  | Unlimited  (** not at all: the caller has limited dt *)
  | Where_used
      (** to at most 1e9 s at each use: the step uses dt only if it is positive, or not at all *)
  | Both_ways  (** at its start *)

val of_program : Ir.program -> t
val seconds : t -> int -> seconds

val nanoseconds : t -> int -> bool
(** Whether a step limits its dt in nanoseconds, at its start. *)
