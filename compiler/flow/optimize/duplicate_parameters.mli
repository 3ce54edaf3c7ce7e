(** Removes parameters that always get the same argument as another parameter.

    If every caller of a node passes the same atom for two of its static parameters or inputs, one
    parameter replaces both. For example, two closures may have captured the same number. A caller
    may pass on its own duplicate parameters, so the equivalence is computed for the whole program.
    Accumulators of loops are never duplicates. {!Dead_code} removes the parameters that are no
    longer read. *)

val program : Ir.program -> Ir.program
(** The result is physically equal to the argument if there are no duplicates. *)
