(** Hash tables keyed by names and other short strings.

    Before OCaml 5, the polymorphic [Hashtbl.hash] first checks in the runtime's page table whether
    its argument is an OCaml block. With a large heap, this takes longer than hashing the few
    characters of a name. *)

include Hashtbl.S with type key = string

val hash : string -> int
(** Hashes all characters. *)
