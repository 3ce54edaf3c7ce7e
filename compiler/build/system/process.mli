(** Runs other programs. *)

type failure =
  | Not_found of string  (** the program, which is not installed *)
  | Failed of { status : int; errors : string }  (** [errors] is the program's output *)

val run : string -> string list -> (unit, failure) result
(** [run program arguments] runs a program silently, without input. The error contains its output.
*)

val output : string -> string list -> (string, failure) result
(** Same as {!run}, but returns everything that the program wrote to standard output and standard
    error. *)

val result : string -> string list -> (string, failure) result
(** Like {!output}, but returns only the program's standard output. If the program succeeds, its
    standard error is forwarded to ours; if it fails, the error contains its standard error. *)

val hand_over : string -> string list -> (int, failure) result
(** Runs a program with our own standard input, output and error. Returns its exit status (128 \+ n
    if signal n ended it). *)

val become : string -> string list -> failure
(** Replaces this process with another program, which from then on also receives the signals sent to
    this process. Returns only if the program cannot be started. *)
