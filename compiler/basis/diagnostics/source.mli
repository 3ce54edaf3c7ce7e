(** The texts that spans point into, by the name under which they are shown.

    A table value that belongs to one compilation: whoever reads a file adds it, the renderers look
    lines up. *)

type t

val create : unit -> t

val add : t -> file:string -> string -> unit
(** The later text wins. *)

val text : t -> string -> string option

val line : t -> string -> int -> string option
(** [line t file n]: line [n] from 1, without its end; [None] if the file is not there or has fewer
    lines. *)

val quote : t -> Span.t -> string option
(** The text there, if it is on one line. *)

val grouped : string -> string
(** An expression as it stands among arguments: in parentheses, if it needs them. *)

val offset : t -> string -> Span.position -> int
(** The position's distance in bytes from the start of the text (0 if the file is not there); never
    beyond its end. *)
