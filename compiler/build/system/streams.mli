(** Standard input, output and error of this process, and of the hosts that replace it. *)

val keep_numbers : unit -> unit
(** Call this before opening anything. If the parent process has closed a standard stream, this
    function occupies its descriptor (0 to 2). Otherwise, the next file that is opened would get
    that descriptor, and printed text would be written to that file, or sent to a robot. Reading and
    writing the stream still fail. *)

val output_fault : unit -> string option
(** Flushes standard output. If that fails, returns the reason, now and in all later calls. *)

val drop_unwritable : unit -> unit
(** Discards output that cannot be written to standard output or error, so that the process ends
    with its intended exit status. *)
