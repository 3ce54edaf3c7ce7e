(** Lets semantic actions reject input that is grammatical but has no meaning. {!Parse} reports the
    diagnostic and continues with the next top-level item. *)

open Basis

exception Rejected of Diagnostic.t

exception Command of { command : Span.t; block : Lexing.position }
(** A command with [-<] in the [do] of tasks that starts at [block]. The right message depends on
    the code around that [do]. *)

exception With_text of ((Span.t -> string option) -> Diagnostic.t)
(** A diagnostic that quotes the source. *)

val with_text : ((Span.t -> string option) -> Diagnostic.t) -> 'a
(** The function receives the source text of a place, if the place is within one line.
    @raise With_text always *)

val diagnostic : Diagnostic.t -> 'a
(** @raise Rejected always *)

val at : code:string -> Span.t -> ?hint:string -> ('a, unit, string, 'b) format4 -> 'a
(** Rejects with an error of this code.
    @raise Rejected always *)
