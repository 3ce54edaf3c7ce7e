(** A computation in a separate process, which can be cancelled at any moment.

    The process is a fork: it starts with a copy of the server's state, and its changes do not
    affect the server. It sends back only its result. Therefore a file that uses up its whole time
    budget does not delay other files, and when an edit makes a computation useless, the server can
    kill the process without leaving partial state behind. *)

type 'a t

val start : (unit -> 'a) -> 'a t
(** Forks a process that calls the function. The function must not write to the standard streams. *)

val descriptor : 'a t -> Unix.file_descr
(** Call {!progress} when this descriptor is readable. *)

(** The state of the computation. [Lost] means that the process ended without a result. *)
type 'a progress = Running | Done of 'a | Lost

val progress : 'a t -> 'a progress
(** Reads the available output. Call it when {!descriptor} is readable, and not again after [Done]
    or [Lost]. *)

val stop : 'a t -> unit
(** Kills the process and discards its result. *)
