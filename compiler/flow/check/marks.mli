(** Computes the maximum number of marks that a program can draw in an instant.

    In the given program, a drawing is an array of [Event Mark] with room for one mark. Only the
    library's primitives create such arrays. They add a mark by replacing an element; no other
    operation changes a drawing. The maximum for each value is therefore the result of a fixpoint
    iteration. Adding a whole drawing also replaces one element, which counts as all the marks in
    that drawing. *)

val limit : int

val most : Ir.program -> int option
(** [None] if the program may draw more marks than {!limit}. *)
