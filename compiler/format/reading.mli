(** Text to {!Word}s.

    The text has to be that of a program that {!Syntax.Parse} accepts. *)

type t = {
  words : Word.t array;
  last : Word.comment list;  (** after the last word *)
  layout : (Syntax.Grammar.token * bool) array;
      (** all that the grammar is given but empty items, and whether layout made it: two texts for
          which these are equal are parsed to the same tree *)
}

val text : string -> t

val without_trailing_blanks : string -> string
(** Of a line. *)
