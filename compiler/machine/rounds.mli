(** What a round of a loop has of its own, as far as no accumulator goes into it.

    A choice of that delays no other round: it can be looked up, where a branch
    would depend on the element, which a processor cannot foresee. Of a value that
    comes from an accumulator the next round waits for the choice. *)

type t

val of_program : Ir.program -> t

val is_own : t -> int -> Ir.expr -> bool
(** In the step of that node: is the expression a round's own, in loops that
    accumulate something? (Other loops compilers do for several elements at
    once.) *)
