(** What a programmer knows of the columns of a program's trace: units, and where inner signals are
    written; as the table of [<frob/columns.h>]. *)

type t = {
  name : string;  (** [in.odometry.position.x], [probe.follow.v]; of an array, without [[0]] *)
  unit_ : string;  (** [m/s], or empty *)
  is_event : bool;  (** of a probe: an event, and not a signal that is not always there *)
  instance : string;  (** of a probe: the signal function that it is in; … *)
  own : string;  (** … its name there; … *)
  file : string;  (** … where it is written, without folders, … *)
  line : int;  (** … from 1. Else empty and 0 *)
}

val of_program :
  Typing.Ir.program ->
  Typing.Ir.definition ->
  Flow.Ir.program ->
  Probe.Catalogue.probe list ->
  t list
(** Those of its inputs and outputs that have a unit, and its probes. The definition is the entry,
    as it was written. *)

val quoted : string -> string
(** A C string. *)

val text : t list -> string
(** A C file. *)
