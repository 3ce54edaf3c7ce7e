(** Maps the file names shown in messages to the texts that spans refer to.

    A table belongs to one compilation. Code that reads a file adds the file's text to the table,
    and the renderers look up lines in it. *)

type t

val create : unit -> t

val add : t -> file:string -> string -> unit
(** Adds the text of a file, replacing any earlier text. *)

val all : t -> (string * string) list
(** All files with their texts, sorted by name. *)

val text : t -> string -> string option

val line : t -> string -> int -> string option
(** [line t file n] is line [n], counted from 1, without its line ending; [None] if the file is
    unknown or has fewer lines. *)

val quote : t -> Span.t -> string option
(** The text of the span; [None] if the span is not within one line. *)

val with_opening : string -> string
(** Adds an opening parenthesis if one is missing, because the span of a signature may start inside
    the parentheses of its context. *)

val grouped : string -> string
(** Adds parentheses around an expression if it would need them as an argument. *)

val offset : t -> string -> Span.position -> int
(** The byte offset of the position in the text, at most the length of the text; 0 if the file is
    unknown. *)
