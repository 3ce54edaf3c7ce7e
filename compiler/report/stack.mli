(** An upper bound on the stack that a call needs: the total size of the frames along a chain of
    calls, for the chain with the largest total.

    The bound assumes a compiler that keeps everything in memory: each frame has a slot for each
    parameter, variable and intermediate value, and for the registers that a call saves. Optimizing
    compilers need less. If they inline a function, the combined frame is not larger than the two
    frames together. The stack usage of the C library's functions is not included. *)

type t = {
  bytes : int;
  chain : int list;  (** the nodes of the largest chain, starting with the root *)
}

type bounds = { reset : t; step : t }

val of_program : Step.Ir.program -> State.t -> bounds
(** Requires the state of the same program, because a trial step copies part of it. *)
