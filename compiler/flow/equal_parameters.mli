(** Static parameters of a node that always have the same value become one: what a
    task needs now and again later, say. Those of a mode are state.

    Those of a type are twins unless someone passes different atoms for them; to
    a node its own twins are the same. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if there are none. *)
