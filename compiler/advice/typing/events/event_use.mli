(** Hints about events and [Maybe] values. The hint depends on where the value is used: as an
    argument of [hold], [accum] or [mergeE], in a pattern or condition, and so on. *)

val mistake : Shape_fact.rule
(** The message with the first hint that applies. *)
