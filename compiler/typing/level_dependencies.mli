(** The edges of a program's {!Level_graph}, in one walk over it.

    Reports [E0346] where a [let] or [where] is recursive: the equations of a
    proc alone may be. *)

val program : Basis.Diagnostic.sink -> Ir.program -> Level_graph.t
(** Not yet solved. *)
