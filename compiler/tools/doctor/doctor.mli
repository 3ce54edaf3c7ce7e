(** [frobc doctor]: checks for everything that a command may need, and explains how to install
    anything that is missing. *)

val run : unit -> int
(** The exit status is 1 if frobc itself does not work on this computer. If something is missing
    that only some commands need, the status is still 0. *)
