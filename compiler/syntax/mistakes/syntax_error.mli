(** What to say where the grammar cannot go on.

    Each state of the automaton has a message of its own in [grammar.messages]; a few tokens
    (reserved words, a bracket's missing partner, [<-], array brackets) say more than the state
    does. *)

open Basis

val report :
  Diagnostic.sink -> text:string -> state:int -> before:Layout.token option -> Layout.token -> unit
(** [report sink ~text ~state ~before token]: [token] does not fit; [before] is the one before it,
    if it belongs to the same item. *)
