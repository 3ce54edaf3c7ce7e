(** Columns of [=], [->], [<-] and [::] that are made of lines below each other.

    Where the author has put those of neighbouring equations (branches, statements, fields) under
    each other by blanks, they stay so, and others of the same group come along. *)

val set : Word.t array -> unit
(** Adds to [gap]; see {!Spacing}. *)
