(** Breaks lines that are too long, at the loosest-binding operator. *)

val line : Word.t array -> first:int -> last:int -> column:int -> outer:int -> inner:int -> unit
(** If the line that consists of these words and starts at [column] is too long, breaks it by
    setting [starts] of one or more words. The rest is then a new line, which the caller must break
    next. Continuation lines start at the column [outer], or at [inner] if they are inside brackets
    that this line opens. *)
