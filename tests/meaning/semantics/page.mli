(** The parts of a Markdown page that a test reads. *)

type table = { line : int; rows : string list list }
(** Rows of cells, the header first, without the rule below it. [line] is the header's. *)

type part =
  | Heading of { line : int; depth : int; text : string }
  | Block of { line : int; language : string; text : string }
  | Table of table
  | Text of { line : int; text : string }  (** one line that is not blank *)

val parts : string -> part list
(** What the text of a page consists of, in its order. *)

val code : string -> string list
(** What stands in backticks in a line. *)

val read : string -> string
(** The contents of a file. *)
