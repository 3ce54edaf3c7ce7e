(** Hash tables keyed by names and other short strings.

    Before OCaml 5, the polymorphic [Hashtbl.hash] first looks up in the runtime's page table
    whether its argument is an OCaml block. In a large heap that costs more than reading the few
    characters of a name. *)

include Hashtbl.S with type key = string

val hash : string -> int
(** Hashes all characters. *)
