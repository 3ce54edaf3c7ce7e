(** Levels: when values are known, and where instances may occur (language reference, section 2).

    An instance runs at every instant of its proc. A branch, a guard or a function may contain an
    instance only if the place of the instance does not affect its output: the signal function must
    be stateless ({!Memory}), and the instance must not mention a variable that has a value only at
    that place.

    Takes an inferred program and fills in the level of each binding. Reports signal functions that
    are run or bound without being static, misplaced instances, recursive lets, and array indices
    that are not constant. A proc inside another proc captures the variables it mentions at the
    instant at which it is created.

    Method: {!Level_dependencies} builds the dependency graph, {!Level_graph} solves it, and a
    second walk checks each place. Linear time. *)

val program : Fact.t Basis.Facts.t -> Ir.program -> Ir.program
