(** A recording, or any trace, as a table of texts: of whichever program. *)

type kind = Number | Truth | Words  (** what else the language writes *)
type column = { name : string; kind : kind  (** of all its cells that are not empty *) }

type t = {
  path : string;
  params : (string * string) list;  (** at its head, as [("kTurn", "4[1/m]")] *)
  columns : column array;  (** [time] is the first *)
  torn : string option;  (** its end is missing: why, and where *)
}

val survey : string -> (t, string) result
(** Reads all of it. The error says file and line. An archive that is cut off ends with its last
    whole row, and so does a file whose last row is torn. *)

val iter : t -> (time:int -> string array -> unit) -> (unit, string) result
(** Each row: its time in nanoseconds, from 0 on and never going back, and its cells. *)

val lines : t -> (string -> unit) -> (unit, string) result
(** Each line that is whole, without its end. *)
