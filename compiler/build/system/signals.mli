(** Converts a process's termination status to an exit status, following the shell convention. *)

val status : Unix.process_status -> int
(** The exit status, or 128 + n if signal n ended the process. Here n is the system's signal number,
    not OCaml's. *)

val name : int -> string option
(** The name of the signal in such a status, for example [SIGKILL] for 137. *)
