(** `frobc format`: formats a program in the style of this project.

    Keeps the author's line breaks in lines that are not too long. The program is split into words
    ({!Reading}). Then follow the blanks between them ({!Spacing}, {!Alignment}), breaks of long
    lines ({!Breaking}), the column of each line ({!Indentation}), and the text with its comments
    ({!Writing}). Each result is checked against the {!Laws}. *)

open Basis

type result =
  | Formatted of string
  | Broken  (** the text is not a program; the sink contains the errors *)
  | Refused of Laws.t  (** the formatter has a bug: its result breaks this law *)

val text : Diagnostic.sink -> file:string -> string -> result
(** [text sink ~file text]: [file] is the name for messages. Accepts any bytes. All lines get the
    same line end as the first line. *)
