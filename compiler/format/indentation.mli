(** Computes the column of each line, from the line that it continues or the block that contains it.
*)

type t = {
  columns : int array;  (** columns of the words that start a line *)
  ended : (int * int) list array;
      (** for each word, the blocks that end before it, innermost first, and the block that contains
          it: the column of their items in the source, and in the result. One more element for the
          end of the file *)
}

val lines : break:bool -> Word.t array -> t
(** If [break] is true, long lines are broken first (see {!Breaking}). *)
