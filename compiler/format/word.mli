(** The formatter's view of a program: its words in source order, with the comments between them and
    the layout information.

    Invariants: the [comments] of a word are between the previous word and this one; the [partner]
    of a bracket is the matching bracket. Lines are numbered from 1; columns are numbered from 0, in
    characters. *)

type comment = {
  text : string;  (** without trailing spaces; may have several lines if it is [{- … -}] *)
  line : int;
  last_line : int;
  column : int;
  own_line : bool;  (** only spaces precede it on its line *)
  blank_before : bool;  (** at least one empty line directly above *)
}

type t = {
  token : Syntax.Lexer.token;
  text : string;
  width : int;  (** in characters *)
  line : int;
  column : int;
  comments : comment list;
  blank_before : bool;  (** at least one empty line directly above, for the first word of a line *)
  closes : int;  (** number of blocks that end before it *)
  opens : bool;  (** whether it is the first word of a block *)
  item : bool;  (** whether it is the first word of an item of a block or of the file *)
  frame : int;
      (** number of the block or bracket pair that contains it; 0 for the file. A bracket is outside
          its own pair *)
  mutable partner : int;  (** for a bracket, the index of the matching one; otherwise -1 *)
  of_cases : bool;  (** directly inside a block of branches *)
  in_unit : bool;  (** in the brackets of a unit, or on the right-hand side of [unit u = …] *)
  prefix : bool;  (** a unary minus sign *)
  in_quotes : bool;  (** the name between backticks, or the closing backtick *)
  in_type : bool;
  mutable commas_first : bool;  (** a bracket of a list whose lines start with commas *)
  mutable starts : bool;  (** starts a line of the result *)
  mutable gap : int;  (** number of spaces before it if it does not start a line *)
}
