(** Lets semantic actions reject input that is grammatical but has no meaning. {!Parse} reports the
    reason and continues with the next top-level item. *)

exception Rejected of Rejection.t

exception Command of { command : Basis.Span.t; block : Lexing.position }
(** A command with [-<] in a [do] block of tasks. [block]: the start of the [do]. *)

val because : Rejection.t -> 'a
(** @raise Rejected always *)
