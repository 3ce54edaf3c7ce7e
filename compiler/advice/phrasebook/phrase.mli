(** A row of the table [words.txt]. The head of that file explains the columns. *)

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

type t = {
  word : string;
  arguments : string list;  (** their names *)
  place : place;
  hint : string option;
  replacement : string option;
}
