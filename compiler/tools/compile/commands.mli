(** Commands that translate a program or print information about it, without running it. Each one
    returns the exit status. They print results on standard output and everything else on standard
    error. *)

val check : Common_options.t -> string list -> int
val compile : Common_options.t -> string -> batch:bool -> standalone:bool -> string -> string -> int

type diagram = Dot  (** for Graphviz *) | Svg

val report : Common_options.t -> entry:string -> states:diagram option -> string -> int
(** Prints the costs of the program, in the format chosen for diagnostics. If [states] is true,
    prints its state diagram instead. *)

val header : string -> int
(** Prints the C header with a robot's types. *)

val explain : string -> int
