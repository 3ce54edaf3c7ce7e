(** Builds the {!Level_graph} of a definition in one walk. Reports [E0346] if a [let] or [where] is
    recursive, unless the recursion is through a signal function or task that restarts itself. *)

val definition : Basis.Diagnostic.sink -> Ir.definition -> Level_graph.t
(** The result must still be solved; see {!Level_graph.solve}. *)
