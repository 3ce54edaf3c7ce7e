(** Of the standard library only the definitions that the program can come to.

    A module that is imported brings all of its definitions, of which a program runs a few: the
    others need no types, levels or Core. All definitions of the program's own modules stay, and of
    the library what these, instances and the defaults of methods mention, directly or through
    others. *)

val program : keep:Ir.Global.t list -> Ir.program -> Ir.program
(** [keep]: definitions of the library that stay in any case. *)
