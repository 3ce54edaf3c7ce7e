(** Describes the columns of a trace for the programmer: their units, and the source locations of
    inner signals. The result is the table of [<frob/columns.h>]. *)

type t = {
  name : string;
      (** for example [in.odometry.position.x] or [probe.follow.v]; for an array, without [[0]] *)
  unit_ : string;  (** for example [m/s]; or empty *)
  is_event : bool;
      (** for a probe: whether it is an event in the program, rather than a signal that exists only
          in some instants *)
  instance : string;  (** for a probe: the signal function that contains it; otherwise empty *)
  own : string;  (** for a probe: its name within that function; otherwise empty *)
  file : string;  (** for a probe: the source file without folders; otherwise empty *)
  line : int;  (** for a probe: the source line, from 1; otherwise 0 *)
}

val declared : Typing.Ir.program -> Flow.Ir.product -> Typing.Ir.ty option
(** The type of a record that is not polymorphic, by its name. *)

val of_program :
  Typing.Ir.program ->
  Typing.Ir.definition ->
  Flow.Ir.program ->
  Probe.Catalogue.probe list ->
  t list
(** The inputs and outputs that have a unit, and the probes. The definition is the entry as written
    in the source. *)

val text : t list -> string
(** The table as a C file. *)
