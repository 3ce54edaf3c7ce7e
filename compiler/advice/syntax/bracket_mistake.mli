(** Messages about brackets: an opening bracket that is never closed, with the likely place of the
    missing bracket, and a closing bracket whose opening bracket is missing or of a different kind.
*)

val report : Found.t -> Basis.Diagnostic.t option
(** [None] if the brackets before the token match. *)
