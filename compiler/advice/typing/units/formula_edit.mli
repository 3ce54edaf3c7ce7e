(** Small changes to a formula, such as [integral] for [derivative], that give it the expected unit.
    A change is suggested only if it is the only one that does so. *)

val suggest : elsewhere:bool -> Unit_rule.t
(** Suggests [integral x] for [derivative x] or the reverse, or the base of a power in place of the
    power. Also looks through the definitions of the names in the formula. If [elsewhere], considers
    only integrals and derivatives that are part of a larger formula or of a definition, because
    these are very likely the mistake. Otherwise, considers only the other changes. *)

val exchanged_angle : Unit_rule.t
(** [angle * sin distance], meant as [distance * sin angle]. *)

val of_a_field : Unit_rule.t
(** A record field whose expected unit is wrong, because it comes from another field that has an
    extra power. *)

val of_a_record : Unit_rule.in_any_context
(** A record with the wrong unit in one field and the expected unit in the others. *)
