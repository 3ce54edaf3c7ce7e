(** Steps that several modes have in common, of which only one runs at an instant.

    A C compiler that copies such a step into each of the modes (clang does, up to
    some size) makes the program larger and no faster: an instant runs one copy, and
    more code has to be in the cache. These functions are marked to stay one. What
    modes do not exclude each other with is left to the compiler: two controllers side
    by side may well be worth two copies. *)

type t

val of_program : Machine.Ir.program -> t

val inline_size : int
(** So few operations are worth a copy at every call. *)

val is_shared : t -> int -> bool
(** Is the node's step to stay one function? *)
