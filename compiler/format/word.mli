(** What a program is to the formatter: its words as they were written, in order, with the comments
    between them and what layout made of their places.

    Always true: [comments] stand between the word before and this one; [partner] of a bracket is
    the bracket that goes with it. Lines count from 1, columns from 0 and in characters. *)

type comment = {
  text : string;  (** without trailing blanks; of several lines if it is [{- … -}] *)
  line : int;
  last_line : int;
  column : int;
  own_line : bool;  (** nothing but blanks before it on its line *)
  blank_before : bool;  (** an empty line or more right above it *)
}

type t = {
  token : Syntax.Lexer.token;
  text : string;
  width : int;  (** characters *)
  line : int;
  column : int;
  comments : comment list;
  blank_before : bool;  (** an empty line or more right above it, where it is first on its line *)
  closes : int;  (** so many blocks end before it *)
  opens : bool;  (** it is the first of a block *)
  item : bool;  (** it is the first of an item of a block, or of the file *)
  frame : int;
      (** what it stands in, a block or brackets: a number, 0 for the file. A bracket stands outside
          of what it encloses. *)
  mutable partner : int;  (** of a bracket: the index of the other one; else -1 *)
  of_cases : bool;  (** it stands directly in a block of branches *)
  in_unit : bool;  (** within the brackets of units, or on the right side of [unit u = …] *)
  prefix : bool;  (** a minus sign of one operand *)
  in_quotes : bool;  (** the name between backticks, or the closing one *)
  in_type : bool;
  mutable commas_first : bool;  (** a bracket of a list whose lines begin with commas *)
  mutable starts : bool;  (** a line of the result *)
  mutable gap : int;  (** blanks before it, where it does not start a line *)
}
