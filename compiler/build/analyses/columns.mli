(** Describes the columns of a trace for the programmer: their units, and the source locations of
    inner signals. The result is the table of [<frob/columns.h>]. *)

type t = {
  name : string;
      (** for example [in.odometry.position.x] or [probe.follow.v]; for an array, without [[0]] *)
  unit_ : string;  (** such as [m/s]; may be empty *)
  is_event : bool;
      (** for a probe: whether it is an [Event] in the program, and not just a signal that has no
          value in some instants *)
  instance : string;  (** for a probe: the signal function that contains it; otherwise empty *)
  own : string;  (** for a probe: its name within that function; otherwise empty *)
  file : string;  (** for a probe: the source file without folders; otherwise empty *)
  line : int;  (** for a probe: the source line, from 1; otherwise 0 *)
}

val declared : Typing.Ir.program -> Flow.Ir.product -> Typing.Ir.ty option
(** Looks up the type of a record by its name. The type must not be polymorphic. *)

val of_program :
  Typing.Ir.program ->
  Typing.Ir.definition ->
  Flow.Ir.program ->
  Probe.Catalogue.probe list ->
  t list
(** The columns of inputs and outputs that have a unit, and the columns of the probes. The second
    argument is the definition of the entry as written in the source. *)

val text : t list -> string
(** The table as a C file. *)
