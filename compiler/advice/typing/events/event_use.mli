(** Hints about an event or a [Maybe], by how it is used: by [hold], [accum] or [mergeE], in a
    pattern or condition, and so on. *)

val mistake : Shape_fact.rule
(** The message with the first hint that applies. *)
