(** Parses the parts of a Markdown page that the tests need. *)

type table = { line : int; rows : string list list }
(** The rows of a table, including the header but not the rule below it. [line] is the header's
    line. *)

type part =
  | Heading of { line : int; depth : int; text : string }
  | Block of { line : int; language : string; text : string }
  | Table of table
  | Text of { line : int; text : string }  (** one line that is not blank *)

val parts : string -> part list
(** The parts of a page, in order. *)

val code : string -> string list
(** The texts in backticks in a line. *)

val read : string -> string
(** The contents of a file. *)
