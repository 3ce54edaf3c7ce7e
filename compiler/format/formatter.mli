(** `frobc format`: formats a program in the style of this project.

    Keeps the author's line breaks in lines that are not too long. The formatter splits the program
    into words ({!Reading}), sets the spaces between them ({!Spacing}, {!Alignment}), breaks long
    lines ({!Breaking}), computes the column of each line ({!Indentation}), and writes the text with
    its comments ({!Writing}). It checks each result against the {!Laws}. *)

open Basis

type result =
  | Formatted of string
  | Broken  (** the text is not a program; its errors have been reported *)
  | Refused of Laws.t  (** the formatter has a bug: its result breaks this law *)

val text : Syntax.Fact.t Facts.t -> file:string -> string -> result
(** [text facts ~file text]: [file] is the file name to use in messages. Accepts any bytes. All
    lines get the same line ending as the first line. *)
