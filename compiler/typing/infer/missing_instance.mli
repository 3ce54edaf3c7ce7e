(** Reports class constraints that are not satisfied, unless another error explains them. *)

open Context

val is_no_robot : Type.t -> bool
(** Is this a type without capabilities, used by mistake in place of a robot's input or output type?
*)

val report : t -> required -> Instance_fact.lack -> unit
(** Reports that an instance needed to satisfy the constraint is missing. *)

val report_unpromised : t -> Instance_fact.promise list -> unit
(** Reports the missing classes in the order in which they are needed. Reports one fact for each
    signature, because a single edit to the signature adds all its missing classes. Omits a class
    that another missing class implies. *)
