(** Handles Ctrl-C and SIGTERM while a file is being written. *)

val protect : finally:(unit -> unit) -> (unit -> 'a) -> 'a
(** Like [Fun.protect], but one of these signals ends the function early, and ends the process only
    after [finally] has run. If a file exceeds the size limit, writing it returns an error. *)

val reported : (unit -> string) -> (unit -> 'a) -> 'a
(** Runs the second function. On Ctrl-C, prints the line that the first function returns (what was
    kept, and how to continue), and then lets the signal end the process. *)
