(** Converts text to {!Word}s.

    The text must be a program that {!Syntax.Parse} accepts. *)

type t = {
  words : Word.t array;
  last : Word.comment list;  (** comments after the last word *)
  layout : (Syntax.Grammar.token * bool) array;
      (** all tokens passed to the grammar except empty items, each with a flag that tells whether
          layout inserted it: two texts with equal lists parse to the same tree *)
}

val text : string -> t

val without_trailing_blanks : string -> string
(** Expects a single line. *)
