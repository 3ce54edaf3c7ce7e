(** What the commands do that make something of a program or say something about it, without running
    it. Each gives the exit status; results go to standard output, everything else to standard
    error. *)

val check : General.t -> string list -> int
val compile : General.t -> string -> batch:bool -> standalone:bool -> string -> string -> int

val report : General.t -> entry:string -> states:bool -> string -> int
(** Prints what the program needs, in the format of the diagnostics; or its state diagram, for
    Graphviz. *)

val header : string -> int
(** Prints the C header with a robot's types. *)

val explain : string -> int
