(** Mistakes with brackets: an opening bracket that is never closed, with the place where its
    partner is probably missing, and a closing bracket without a partner or with a partner of a
    different kind. *)

val report : Found.t -> Basis.Diagnostic.t option
(** [None] if the brackets before the token match. *)
