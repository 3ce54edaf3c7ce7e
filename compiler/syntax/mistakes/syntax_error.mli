(** Reports syntax errors.

    Each state of the automaton has its own message in [grammar.messages]. A few tokens (reserved
    words, an unmatched bracket, [<-], array brackets) have more specific messages. *)

open Basis

val command :
  Diagnostic.sink -> text:string -> command:Span.t -> block:Lexing.position -> Layout.token -> unit
(** Reports a command in the [do] at [block], which is a [do] of tasks. The token is the first one
    after the part of the [do] that contains the command. *)

val report :
  Diagnostic.sink -> text:string -> state:int -> before:Layout.token option -> Layout.token -> unit
(** [report sink ~text ~state ~before token] reports that the parser cannot accept [token].
    [before]: the preceding token, if it belongs to the same item. *)
