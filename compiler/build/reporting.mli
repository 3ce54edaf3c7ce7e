(** Ends a command: prints messages on standard error and determines the exit status. *)

val colour : unit -> bool
(** Whether standard error is a terminal that shows colours, and the user has not disabled them. *)

val print_diagnostics : Common_options.format -> Basis.Source.t -> Basis.Diagnostic.sink -> unit
(** Prints all diagnostics on standard error. *)

val status : Basis.Diagnostic.sink -> int
(** The exit status of a command that compiles a program, given the diagnostics in the sink. *)

val wrong_use : string -> int
(** Prints an error about the command line, and returns {!Exit_status.wrong_use}. *)

val ( let* ) : ('a, string) result -> ('a -> int) -> int
(** Continues with a value, or reports a usage error. *)

val report_bug : string -> string -> int
(** [report_bug stage message] reports a bug in the compiler. *)

val report_exception : exn -> int
(** Reports the exception that ended the command: an operating system error, with the status
    {!Exit_status.wrong_use}, or a bug in the compiler, with the status {!Exit_status.bug}. *)
