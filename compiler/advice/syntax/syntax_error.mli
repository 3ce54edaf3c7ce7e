(** Messages about tokens that the parser cannot accept.

    Each state of the automaton has its own message in [grammar.messages]. A few tokens (reserved
    words, an unmatched bracket, [<-], array brackets) have more specific messages. *)

open Basis
open Syntax

val command : text:string -> command:Span.t -> block:Lexing.position -> Layout.token -> Diagnostic.t
(** The error for a command in a [do] of tasks or in a branch of a [proc]. [block]: the position of
    the [do]. The token is the first one after the part of the [do] that contains the command. *)

val unexpected :
  told:Diagnostic.t list ->
  text:string ->
  state:int ->
  before:Layout.token option ->
  Layout.token ->
  Diagnostic.t option
(** [before]: the preceding token, if it belongs to the same item. [told]: the earlier diagnostics
    for the file; the result is [None] if one of them explains this token. *)
