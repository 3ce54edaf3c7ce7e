(** The points of a sweep: the values that parameters are given together. *)

type axis = {
  name : string;
  unit_ : string;  (** [1/m]; [1]; empty of a truth value *)
  along : along;
}
(** A parameter that varies, or is set. *)

and along =
  | Between of { low : float; high : float; steps : int; whole : bool  (** an Int *) }
  | Each of string list  (** as a host reads them *)

val count : sampling:Plan.sampling -> points:int -> axis list -> int
(** How many {!all} gives, or more where steps of an Int fall together. *)

val all : sampling:Plan.sampling -> points:int -> seed:int -> axis list -> string array list
(** Of each point a value for each axis, as a host reads it. A grid has every combination, the last
    axis fastest; its steps are rounded to twelve digits. [Random]: so many points, each value drawn
    evenly and by itself. [Latin]: a Latin hypercube (McKay, Beckman and Conover, Technometrics 21,
    1979): of each axis's range cut into as many parts as there are points, each part has one. The
    same seed gives the same. *)
