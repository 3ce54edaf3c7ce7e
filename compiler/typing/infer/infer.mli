(** Infers the types and units of a whole program (language reference, sections 2 and 4).

    Hindley-Milner inference over the top-level groups in dependency order, extended by units of
    measure as an abelian group, the classes Eq and Ord, and questions that are postponed until
    types are known ({!Context.question}). If a definition contains an error, inference continues
    with the other definitions. Types that are unknown because of an error unify with everything, so
    that each mistake is reported once. The levels are provisional: {!Levels} computes them. *)

open Basis

val program : ?sources:Source.t -> Fact.t Facts.t -> real:Real.t -> Resolve.Ir.program -> Ir.program
(** [sources]: the files that messages quote from. [real]: the precision of [Float], which
    determines the range of literals. Reports [E03xx]. After errors the result has the shape of the
    program, with arbitrary types in place of erroneous ones: the correct parts can be checked
    further, but the program cannot be translated. *)
