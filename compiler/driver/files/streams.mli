(** Standard input, output and error of this process and of the hosts that it becomes. *)

val keep_numbers : unit -> unit
(** To be called before anything is opened. Where a stream was closed by who started the process,
    its number (0 to 2) is taken, as it would be that of what is opened next: what is printed would
    end up in a file, or with a robot. Reading and writing the stream fail as before. *)

val output_fault : unit -> string option
(** Writes what is left of standard output; the reason if that is not possible, also when asked
    again. *)

val drop_unwritable : unit -> unit
(** What cannot be written to standard output or error is dropped, so that the process ends with the
    status that it has found. *)
