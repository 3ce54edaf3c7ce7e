(** Types and units of a whole program (language reference, sections 2 and 4).

    Hindley-Milner over the top-level groups in dependency order, with units of measure as an
    abelian group, the classes Eq and Ord, and questions that wait for types ({!Context.question}).
    A definition in error does not stop the others; what an error leaves unknown agrees with
    everything, so one mistake gives one message. Levels are provisional: {!Levels} fills them in.
*)

open Basis

val program :
  ?sources:Source.t -> Diagnostic.sink -> real:Real.t -> Resolve.Ir.program -> Ir.program
(** [sources]: what messages quote from. [real]: the precision of [Float], which says what literals
    are in range. Emits [E03xx]. After errors the result has the shape of the program, with
    arbitrary types where an error was: fit for further checks of what is right, not for
    translation. *)
