(** Flow programs built by hand. Each illustrates the point that its name describes. *)

val all : (string * Flow.Ir.program) list
