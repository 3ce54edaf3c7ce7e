(** A version of a text that the compiler was able to analyse. Translates places between this
    version and the current text. *)

open Basis

type t

val of_analysis : Mentions.declared Text_cache.t -> Analysis.t -> t option
(** [None] if name resolution failed. The cache is passed to {!Index.of_analysis}. *)

val analysis : t -> Analysis.t
val tree : t -> Syntax.Ir.program
val index : t -> Index.t

val facts : t -> Place_types.t option
(** [None] if type checking failed. *)

val program : t -> Resolve.Ir.program

val prepare : t -> unit
(** Computes the lazy parts in advance. *)

(** {1 Places}

    Places in the current text are offsets. Places in the version are positions or spans. *)

type seen = { view : t; now : Text.t; shift : Shift.t; back : Shift.t }

val seen : t -> Text.t -> Shift.t -> seen
(** [shift] maps the version to the current text. *)

val position : seen -> int -> Span.position option

val place : seen -> Span.t -> (int * int) option
(** Maps a word in the version to its place in the current text. *)

val place_at : seen -> int -> Span.t -> (int * int) option
(** Like {!place}, but [None] if the word does not contain this offset of the current text. *)

val range : seen -> Span.t -> (int * int) option
(** Like {!place}, but for a range that is longer than a word and whose contents may have changed.
*)
