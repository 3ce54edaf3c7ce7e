(** Where values of a program's columns come from, as the table of [<frob/origins.h>]. *)

val text : Probe.Origin.t list -> string
(** A C file. *)
