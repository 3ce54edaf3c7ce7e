(** Removes the library definitions that the program does not use.

    An imported module brings all of its definitions into the program, but a program uses few of
    them. The others need no type checking or translation. All definitions of the program's own
    modules stay. A library definition stays if these, an instance or a default method mention it,
    directly or through other definitions. *)

val program : keep:Ir.Global.t list -> Ir.program -> Ir.program
(** [keep]: library definitions that stay in any case. *)
