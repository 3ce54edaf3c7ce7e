(** Handles Ctrl-C and SIGTERM while a file is being written. *)

val protect : finally:(unit -> unit) -> (unit -> 'a) -> 'a
(** Like [Fun.protect], but also delays these signals until [finally] has run; then they end the
    process. Exceeding the file size limit becomes an error. *)

val reported : (unit -> string) -> (unit -> 'a) -> 'a
(** Runs the second function. On Ctrl-C, prints the line that the first function returns (what was
    kept, and how to continue), and then lets the signal end the process. *)
