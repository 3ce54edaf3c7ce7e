(** A recording, or any other trace, as a table of strings. Reading it does not require the program
    that recorded it. *)

type kind = Number | Truth | Words  (** any other kind of value *)
type column = { name : string; kind : kind  (** the kind of all its non-empty cells *) }

type t = {
  path : string;
  dialect : Interp.Dialect.t;
  params : (string * string) list;  (** recorded parameters, such as [("kTurn", "4[1/m]")] *)
  columns : column array;  (** [time] comes first *)
  torn : string option;  (** if the end is missing: where the recording breaks off, and why *)
}

val survey : dialect:Interp.Dialect.t -> string -> (t, string) result
(** Reads the whole file. The error contains the file and line. If an archive or the last row is
    truncated, the recording ends with the last complete row. *)

val iter : t -> (time:int -> string array -> unit) -> (unit, string) result
(** Calls the function for each row, with its time in nanoseconds and its cells. Times are not
    negative and never decrease. *)

val lines : t -> (string -> unit) -> (unit, string) result
(** Calls the function with each complete line, without its line ending, translated from the dialect
    to Frob's format. *)
