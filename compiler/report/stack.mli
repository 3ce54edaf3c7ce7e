(** A bound of the stack that a call needs: of every chain of calls the sum of its functions'
    frames, and the longest of these.

    A frame is taken as a compiler makes it that keeps everything in memory: a place for each
    parameter, variable and intermediate value, and what a call saves. Optimizing compilers need
    less, and when they copy a function into its caller the frames become one that is not larger
    than both. What the C library's functions need comes on top. *)

type t = { bytes : int; chain : int list  (** the nodes of the longest chain, the root first *) }
type bounds = { reset : t; step : t }

val of_program : Step.Ir.program -> State.t -> bounds
(** With the state of that program: a step on trial copies some of it. *)
