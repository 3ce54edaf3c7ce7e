(** The C files of a program, as text. *)

type t = {
  header : string;  (** NAME.h *)
  source : string;  (** NAME.c *)
  host_table : string;  (** NAME_host.c, for hosts only *)
}

val program : Machine.Ir.program -> t
