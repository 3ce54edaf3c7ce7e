(** The C files of a program. *)

type t = {
  header : string;  (** NAME.h *)
  source : string;  (** NAME.c *)
}

val program : Machine.Ir.program -> t
