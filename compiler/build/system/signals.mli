(** Converts the way in which a process ended to an exit status, following the shell convention. *)

val status : Unix.process_status -> int
(** The exit status, or 128 + n if signal n ended the process. Here n is the signal number of the
    system, not of OCaml. *)

val name : int -> string option
(** The name of the signal in such a status, for example [SIGKILL] for 137. *)
