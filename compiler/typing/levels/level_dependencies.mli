(** Builds the {!Level_graph} of a definition in one walk.

    Reports [E0346] if a [let] or [where] is recursive, unless through a signal function or task
    that starts itself again. *)

val definition : Basis.Diagnostic.sink -> Ir.definition -> Level_graph.t
(** The graph is not solved yet. *)
