(** Tables by names and other short texts.

    [Hashtbl.hash], which takes anything, first looks up in OCaml's table of pages whether what it
    got is a block of OCaml's (before OCaml 5): in a large heap that costs more than reading the few
    characters of a name. *)

include Hashtbl.S with type key = string

val hash : string -> int
(** Of all characters. *)
