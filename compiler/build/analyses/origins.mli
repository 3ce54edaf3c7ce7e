(** The sources of the values in a program's columns, as the table of [<frob/origins.h>]. *)

val text : Probe.Origin.t list -> string
(** The table as a C file. *)
