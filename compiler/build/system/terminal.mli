(** Shows a progress line on standard error if it is a terminal. *)

val show : head:string -> tail:string -> unit
(** Replaces the progress line with [head: tail], and truncates the head so that the line fits the
    current width of the terminal. Does nothing if standard error is not a terminal. *)

val clear : unit -> unit
(** Removes the progress line. *)
