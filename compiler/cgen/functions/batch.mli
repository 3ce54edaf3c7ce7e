(** Many steps in one call, for replay and simulation: a function that takes arrays of inputs and
    gives arrays of outputs, in the source file of the step, where a C compiler can join the two.
    Each step is the one that the program has: seconds, or in single precision whole nanoseconds, so
    outputs are equal bit for bit. *)

type t = {
  prototype : string;  (** for the header, with a comment *)
  definition : string;  (** for the source, after the step *)
}

val of_program : Vocabulary.t -> t
(** [NAME_steps]. *)
