(** Flow programs built by hand, each for the point that its name makes. *)

val all : (string * Flow.Ir.program) list
