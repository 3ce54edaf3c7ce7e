(** Wrong units in the source: a superfluous factor such as [1[m]], and a gain, a constant or a
    parameter whose use requires a different unit. *)

val superfluous_factor : Unit_rule.t
(** [sqrt (x ^ 2 + y ^ 2) * 1[m]] where a length is needed. *)

val superfluous_function : Unit_rule.t
(** [integral v] or [derivative x] where [v] or [x] is needed. *)

val gain : Unit_rule.t
(** A term whose gain has the wrong unit: [4[rad/(m s)] * e + 2[rad/(m s)] * derivative e]. *)

val constant : Unit_rule.t
(** A name that is defined as a number with the wrong unit. *)

val bare_parameter : Unit_rule.t
(** A parameter used as a factor, whose type in the signature has no unit. *)

val parameter : Unit_rule.t
(** A parameter whose type in the signature has the wrong unit. *)
