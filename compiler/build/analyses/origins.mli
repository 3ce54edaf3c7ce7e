(** Describes where the values in a trace's columns come from. The result is the table of
    [<frob/origins.h>]. *)

val text : Probe.Origin.t list -> string
(** The table as a C file. *)
