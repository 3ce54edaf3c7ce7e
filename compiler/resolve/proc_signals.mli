(** The signals of a [proc], for messages: a [where] after [proc … -> do]
    belongs to the definition around it and does not see them. *)

val of_body : Syntax.Ir.body -> Syntax.Ir.name list
(** What the [proc] that this body is binds: its input and, in its [do], the
    statements. *)
