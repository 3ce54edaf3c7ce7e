(** The points of a sweep: combinations of parameter values. *)

type axis = {
  name : string;
  unit_ : string;  (** for example [1/m]; [1] for a plain number; empty for a Bool *)
  along : along;
}
(** The values of a parameter that varies, or the only value of one that does not. *)

and along =
  | Between of { low : float; high : float; steps : int; whole : bool  (** whether it is an Int *) }
  | Each of string list  (** the values in the format that a host reads *)

val count : sampling:Plan.sampling -> points:int -> axis list -> int
(** The number of points; for a [Grid], at most 1e9. {!all} returns fewer points if several steps
    round to the same Int. *)

val all : sampling:Plan.sampling -> points:int -> seed:int -> axis list -> string array list
(** One value for each axis of each point, in the format that a host reads.

    - [Grid]: all combinations; the last axis varies fastest. Steps are rounded to twelve digits.
    - [Random]: [points] points, with independent, uniformly distributed values.
    - [Latin]: a Latin hypercube (McKay, Beckman and Conover, Technometrics 21, 1979). The range of
      each axis is divided into as many intervals as there are points, and each interval contains
      one point.

    The same seed always produces the same points. *)
