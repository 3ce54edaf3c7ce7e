(** The edges of a definition's {!Level_graph}, in one walk over it.

    Reports [E0346] where a [let] or [where] is recursive: the equations of a
    proc alone may be. *)

val definition : Basis.Diagnostic.sink -> Ir.definition -> Level_graph.t
(** Not yet solved. *)
