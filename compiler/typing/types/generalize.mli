(** Quantifying what a top-level group leaves open.

    Every variable still open in the types of the group's definitions becomes a variable of their
    schemes, named in the order in which it is met. Units are put into their simplest principal form
    on the way (Kennedy, "Types for units-of-measure", 2009, section 3.5), see {!Units.generalize}.
*)

type t = { types : Type.rigid list; representations : Units.rigid list; units : Units.rigid list }

val none : t

val types : Type.supply -> depth:int -> Type.t list -> t
(** Afterwards nothing in the types is open. *)
