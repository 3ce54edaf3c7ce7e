(** The text of [runtime/include/frob/step.h], embedded when the compiler is built. *)

val text : string
