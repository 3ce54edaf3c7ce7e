(** Folds constants, and removes copies and choices that are already decided.

    No rewrite may change a bit of any output, so for Floats the pass uses only identities that hold
    for every value. For example, [x + 0] is not replaced with [x], because [-0 + 0] is [0]. If a
    copy has a name from the programmer and its original has none, the original inherits it. An
    operation on a choice between known values becomes a choice between the results. The equations
    may be in any order, but the pass is most effective on acyclic nodes. The pass takes linear
    time. *)

val program : Ir.program -> Ir.program
(** The result is physically equal to the argument if nothing is simplified. *)

val after : (Ir.node -> Ir.node) -> Ir.program -> Ir.program
(** Applies a function to each node, and simplifies those that it changes. *)
