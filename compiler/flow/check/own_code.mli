(** Distinguishes the user's own code, which the user can change, from the library. Messages about
    the library's code refer to the user's code that calls it.

    The parameter [entry] is the place of the program's definition. *)

val is_own : entry:Basis.Span.t -> Basis.Span.t -> bool
(** Whether this place is in a module of the program. The modules of a program are in one folder,
    and those of the library in another. *)

type uses

val uses : Ir.program -> uses
(** The first instance of each node. *)

val use : uses -> entry:Basis.Span.t -> int -> (string * Basis.Span.t) option
(** For a node (given by its index) outside the entry's module: the name and place of the instance
    in the entry's module that directly or indirectly runs the node. If there is no such instance,
    the place is [entry]. [None] for a node in the entry's module. *)
