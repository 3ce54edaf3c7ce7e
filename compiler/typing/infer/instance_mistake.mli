(** Messages about class constraints that are not satisfied: [E0307] the type has no equality or
    order · [E0308] a class is required of a type that nothing determines · [E0360] there is no
    instance · [E0371] a task is required. *)

open Context

type lack = { lacking : Ir.class_; culprit : Type.t; through : Environment.instance list }
(** A constraint that cannot be satisfied, and the instances that led to it, in reverse order. *)

val is_no_robot : Type.t -> bool
(** Is this a type without capabilities, used by mistake in place of a robot's input or output type?
*)

val lacking : t -> required -> lack -> unit
(** Reports that an instance needed for the required constraint is missing. *)

val undecided : t -> required -> Ir.class_ -> unit
(** Reports that nothing determines the type for which the class is required. *)
