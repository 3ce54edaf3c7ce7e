(** The text of [runtime/include/frob/step.h] when the compiler was built. *)

val text : string
