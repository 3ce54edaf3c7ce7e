(** Ctrl-C and SIGTERM while something is on its way to a file. *)

val protect : finally:(unit -> unit) -> (unit -> 'a) -> 'a
(** As [Fun.protect], and the signals, too, come only after [finally]: the process then ends by
    them. A file that has reached the limit of its size is an error. *)
