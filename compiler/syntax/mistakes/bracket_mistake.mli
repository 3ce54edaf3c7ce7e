(** Mistakes with brackets: a bracket that is never closed, with the place where its partner is
    probably missing, and one that closes nothing or another kind of bracket. *)

val report : Found.t -> Basis.Diagnostic.t option
(** [None] if the brackets before the token match. *)
