(** Reports syntax errors.

    Each state of the automaton has its own message in [grammar.messages]. A few tokens (reserved
    words, an unmatched bracket, [<-], array brackets) have more specific messages. *)

open Basis

val command :
  Diagnostic.sink -> text:string -> command:Span.t -> block:Lexing.position -> Layout.token -> unit
(** Reports a command in the [do] at [block], which is one of tasks. The token is the next one after
    a part of that [do]. *)

val report :
  Diagnostic.sink -> text:string -> state:int -> before:Layout.token option -> Layout.token -> unit
(** [report sink ~text ~state ~before token] reports that the parser cannot accept [token].
    [before]: the token before it, if that belongs to the same item. *)
