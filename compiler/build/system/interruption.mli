(** Handles Ctrl-C and SIGTERM while a file is being written. *)

val protect : finally:(unit -> unit) -> (unit -> 'a) -> 'a
(** Like [Fun.protect], but also delays these signals until [finally] has run; then they end the
    process. Exceeding the file size limit becomes an error. *)

val reported : (unit -> string) -> (unit -> 'a) -> 'a
(** On Ctrl-C, prints the line that this function returns (what was kept, and how to continue), and
    then the signal ends the process. *)
