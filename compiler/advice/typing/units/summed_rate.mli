(** An equation that adds up a rate without [integral], such as [x = delay 0 x + 0.02 * v]. *)

val complete : Unit_rule.t
(** Completes the message about two units that differ by a factor of [s]. *)
