(** Which signal functions remember: what they give depends on when they started.

    One that does not gives the same whether it runs always or only where its value is asked for, so
    that its place in the program says nothing about when it runs. Senses are held for such too:
    methods of type [SF i …] in a class of [i] tell how things are for a robot now. *)

type t

val create : Ir.program -> t

val local : t -> Ir.binding -> unit
(** A binding that the program's procs may run. *)

val remembers : t -> Ir.expr -> bool
(** What is run, with all the arguments in it. On the safe side where it is not known. *)
