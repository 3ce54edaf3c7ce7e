(** Handles signals that end the process: Ctrl-C, SIGTERM and SIGHUP. *)

val protect : finally:(unit -> unit) -> (unit -> 'a) -> 'a
(** Like [Fun.protect], but if one of these signals arrives, the function ends early, and the
    process ends after [finally] has run. If a file exceeds the size limit, writing to it fails with
    an error instead of ending the process. *)

val reported : (unit -> string) -> (unit -> 'a) -> 'a
(** Runs the second function. On Ctrl-C, prints the line that the first function returns (what was
    kept, and how to continue), and then lets the signal end the process. *)
