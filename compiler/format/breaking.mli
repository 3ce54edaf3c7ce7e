(** Lines that are too long are broken where a reader would: at what binds least. *)

val most : int
(** Characters of a line. *)

val line : Word.t array -> first:int -> last:int -> column:int -> outer:int -> inner:int -> unit
(** The line of these words stands at [column]. If it is too long, sets [starts] of one of them, or
    of more; the rest then is a line to be looked at in its turn. A continuation of the line stands
    at the column [outer], or at [inner] within brackets that it opens. *)
