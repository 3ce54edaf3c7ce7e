(** `frobc format`: a program as this project writes programs.

    Lines stay where the author broke them if they are not too long. From the program's words
    ({!Reading}) come the blanks between them ({!Spacing}, {!Alignment}), the breaks of long lines
    ({!Breaking}), each line's column ({!Indentation}), and with the comments its text ({!Writing}).
    What comes out is checked against the {!Laws} each time. *)

open Basis

type result =
  | Formatted of string
  | Broken  (** no program: the sink knows why *)
  | Refused of Laws.t  (** the formatter is at fault *)

val text : Diagnostic.sink -> file:string -> string -> result
(** [text sink ~file text]: [file] is the name to show. Takes any bytes. *)
