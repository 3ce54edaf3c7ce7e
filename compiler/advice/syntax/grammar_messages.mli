(** Generated from [grammar.messages]. *)

val message : int -> string
(** The message for this error state of the automaton. A test ensures that every state has one.
    @raise Not_found if there is no message for the state *)
