(** Converts text to {!Word}s.

    The text must be a program that {!Syntax.Parse} accepts. *)

type t = {
  words : Word.t array;
  last : Word.comment list;  (** comments after the last word *)
  layout : (Syntax.Grammar.token * bool) array;
      (** all tokens that the grammar receives, except empty items, each with a flag that says
          whether layout inserted it. Two texts with equal lists parse to the same tree *)
}

val text : string -> t

val without_trailing_blanks : string -> string
(** Expects a single line. *)
