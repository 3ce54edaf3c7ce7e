(** The column of each line, from what it continues or in what block it stands. *)

type t = {
  columns : int array;  (** of the words that start a line *)
  ended : (int * int) list array;
      (** of the blocks that end before a word, innermost first, and of the one that it is in: the
          column at which their items stood, and that at which they stand now; one more for the end
          of the file *)
}

val lines : break:bool -> Word.t array -> t
(** With [break], too long lines are broken first; see {!Breaking}. *)
