(** A version of a text that the compiler understood, seen from the text as it is now. *)

open Basis

type t

val of_analysis : Analysis.t -> t option
(** [None] if names are wrong. *)

val analysis : t -> Analysis.t
val tree : t -> Syntax.Ir.program
val index : t -> Index.t

val facts : t -> Facts.t option
(** [None] if types are wrong. *)

val program : t -> Resolve.Ir.program

val prepare : t -> unit
(** Computes what would else be computed when first asked for. *)

(** {1 Places}

    Those of the present text are offsets, those of the version positions. *)

type seen = { view : t; now : Text.t; shift : Shift.t; back : Shift.t }

val seen : t -> Text.t -> Shift.t -> seen
(** [shift]: from the version to this text. *)

val position : seen -> int -> Span.position option

val place : seen -> Span.t -> (int * int) option
(** Where a word of the version is now. *)

val place_at : seen -> int -> Span.t -> (int * int) option
(** If this offset of the present text is in it. *)

val range : seen -> Span.t -> (int * int) option
(** Likewise of something larger, which may have changed inside. *)
