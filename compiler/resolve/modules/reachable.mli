(** Removes the library definitions that the program does not use.

    An imported module brings all of its definitions into the program, but a program uses few of
    them. The others do not need type checking or translation. All definitions of the program's own
    modules are kept. A library definition is kept if one of these definitions, an instance or a
    default method mentions it, directly or through other definitions. *)

val program : keep:Ir.Global.t list -> Ir.program -> Ir.program
(** [keep]: library definitions that are never removed. *)
