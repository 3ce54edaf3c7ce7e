(** Nodes that nothing runs any more disappear, as most do that were inlined. {!Dead}
    does that too, and much else, so this is for the sake of passes that come between. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if each node runs. *)
