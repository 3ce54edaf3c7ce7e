(** The edges of a definition's {!Level_graph}, in one walk over it.

    Reports [E0346] where a [let] or [where] is recursive otherwise than by a signal function or
    task that may go on as itself. *)

val definition : Basis.Diagnostic.sink -> Ir.definition -> Level_graph.t
(** Not yet solved. *)
