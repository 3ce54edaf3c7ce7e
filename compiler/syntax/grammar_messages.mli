(** Generated from [grammar.messages]. *)

val message : int -> string
(** What to say in this error state of the automaton. Raises [Not_found] if there is nothing, which
    a test excludes. *)
