(** What typing reports, as a value without any text. [Advice] turns it into a diagnostic. *)

type t = Pattern of Pattern_fact.t
