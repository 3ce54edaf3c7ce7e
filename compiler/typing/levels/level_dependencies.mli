(** Builds the {!Level_graph} of a definition in one walk. Reports a [let] or [where] that is
    recursive, unless the recursion is through a signal function or task that restarts itself. *)

val definition : Fact.t Basis.Facts.t -> Ir.definition -> Level_graph.t
(** The result must still be solved; see {!Level_graph.solve}. *)
