(** The message of each error state of the automaton, from [grammar.messages]. *)

type expects =
  | Equals  (** after the left-hand side of a definition *)
  | Arrow  (** after the input of a [proc] or a parameter of a lambda *)
  | Other

type t = {
  expected : string;  (** the start of the message, up to ", found …" *)
  hints : string list;
  expects : expects;
}

val of_state : int -> t
