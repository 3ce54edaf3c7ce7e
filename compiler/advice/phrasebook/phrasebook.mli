(** Words of other languages, from the table [words.txt]. The head of that file explains the rows.
*)

type place =
  | Value
  | Robot
  | Call
  | Reading
  | Speed
  | Controller
  | In_array
  | In_event
  | In_task
  | Operator
  | Object
  | Constructor
  | Type
  | Class
  | Qualifier
  | Module
  | Library
  | Unit

type row = {
  word : string;
  arguments : string list;  (** their names *)
  place : place;
  hint : string option;
  replacement : string option;
}

val rows : row list Lazy.t
(** All rows, in the order of the table. *)

val find : place -> string -> row option
(** The first row for the word at this place. *)

val hint : row -> string
(** The hint in the row or, if there is none, a hint that suggests the replacement. *)

val name : row -> string option
(** The replacement, if it is one word and the row has no hint. *)

val applied : place -> string -> string list -> (string * row) option
(** The replacement in the first row for the word at this place that has the given number of
    arguments, with these arguments substituted. *)
