(** Dead code elimination. Removes everything that no output of the program depends on: equations,
    instances, static parameters, inputs and outputs of nodes, and whole nodes.

    A parameter is needed if something needed in its node reads it, in any instant. In that case,
    its arguments in all needed instances are also needed. The pass is a single search from the
    outputs of the root, linear in the size of the program. The root's own inputs and outputs are
    kept, because they are the program's interface. *)

val program : Ir.program -> Ir.program
