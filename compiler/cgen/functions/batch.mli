(** Generates a function that runs many steps in one call, for replay and simulation. It takes
    arrays of inputs and fills arrays of outputs. It is defined in the same source file as the step,
    so that C compilers can inline the step. It calls the root's step, which takes dt both in
    nanoseconds and in seconds and converts neither, so the outputs are bit-for-bit identical to
    those of single steps. *)

type t = {
  prototype : string;  (** text for the header, including a comment *)
  definition : string;  (** text for the source, to insert after the step *)
}

val of_program : Program_names.t -> t
(** Generates [NAME_steps]. *)
