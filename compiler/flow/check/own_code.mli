(** What of a program its programmer wrote, and can change: for messages about what the library does
    with it.

    The entry, below, is where the program is defined. *)

val is_own : entry:Basis.Span.t -> Basis.Span.t -> bool
(** Is this place in a module of the program? They lie in one folder, the library's in another. *)

type uses

val uses : Ir.program -> uses
(** For each node the first instance of it. *)

val use : uses -> entry:Basis.Span.t -> int -> (string * Basis.Span.t) option
(** Of a node of another module than the entry's, by its index: what the entry's own module runs
    there, and where; the entry itself may be such a node. *)
