(** Keeps [=], [->], [<-] and [::] of neighbouring lines aligned.

    If the author has aligned these signs in neighbouring equations, branches, statements or fields,
    they stay aligned, and other lines of the same group are aligned with them. *)

val set : Word.t array -> unit
(** Aligns signs by increasing their [gap]. {!Spacing.set} must have set the gaps. *)
