(** The exit statuses of [frobc], a contract with scripts. *)

val ok : int
(** Done. *)

val rejected : int
(** The program was rejected; diagnostics are on standard error. *)

val wrong_use : int
(** Wrong use, missing file, unreadable input, missing tool. *)

val bug : int
(** A bug in frobc. *)

val fault : int
(** The run ended in a fault: robot lost, watchdog, collision limit, an assertion. *)
