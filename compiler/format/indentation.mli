(** Computes the column of each line, from the line that it continues or the block that contains it.
*)

type t = {
  columns : int array;  (** columns of the words that start a line *)
  ended : (int * int) list array;
      (** for each word, a list of the blocks that end before the word, innermost first, followed by
          the block that contains it. A block is represented by the column of its items in the
          source and their column in the result. The array has one more element, for the end of the
          file *)
}

val lines : break:bool -> Word.t array -> t
(** If [break] is true, long lines are broken first (see {!Breaking}). *)
