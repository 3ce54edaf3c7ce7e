(** Generalization: quantifies the variables that a top-level group leaves unsolved.

    Every unsolved variable in the types of the group's definitions becomes a quantified variable of
    their schemes, named in order of occurrence. Units are converted to their simplest principal
    form (Kennedy, "Types for units-of-measure", 2009, section 3.5); see {!Units.generalize}. *)

type t = { types : Type.rigid list; representations : Units.rigid list; units : Units.rigid list }

val none : t

val types : Type.supply -> depth:int -> Type.t list -> t
(** After the call, the types do not contain unsolved variables. *)
