(** [runtime/include/frob/step.h], as it was when the compiler was built. *)

val text : string
