(** The exit statuses of [frobc], on which scripts may rely. *)

val ok : int
(** Success. *)

val rejected : int
(** The program was rejected; diagnostics are on standard error. *)

val wrong_use : int
(** A usage error, a missing file, unreadable input, or a missing tool. *)

val bug : int
(** A bug in frobc. *)

val fault : int
(** The run ended with a fault: robot lost, watchdog, collision limit, or a violated assertion. *)
