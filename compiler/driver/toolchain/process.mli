(** Other programs that frobc starts. *)

type failure =
  | Not_found of string  (** the program; it is not installed *)
  | Failed of { status : int; errors : string }  (** what it wrote *)

val run : string -> string list -> (unit, failure) result
(** [run program arguments], quietly: its output is kept for the failure. *)

val output : string -> string list -> (string, failure) result
(** Likewise; what it wrote is the result. *)

val hand_over : string -> string list -> (int, failure) result
(** Runs a program with our own standard input, output and error; the result is its exit status (128
    \+ n if signal n ended it). *)

val become : string -> string list -> failure
(** Goes on as another program, in our place: signals for us are signals for it. Returns only if it
    cannot be started. *)
