(** Tables by small numbers, such as the ids of signals, variables and fields.

    What the polymorphic [Hashtbl] spends on hashing and comparing a key is here
    one instruction each; passes look signals up a hundred times for each line of
    a program. *)

include Hashtbl.S with type key = int
