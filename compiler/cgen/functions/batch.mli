(** Generates a function that runs many steps in one call, for replay and simulation. It takes
    arrays of inputs and fills arrays of outputs. It is in the source file of the step, so that C
    compilers can inline the step. Each step uses the function with the program's own unit of time
    (seconds or, in single precision, whole nanoseconds). The outputs therefore equal those of
    single steps, bit for bit. *)

type t = {
  prototype : string;  (** text for the header, including a comment *)
  definition : string;  (** text for the source, to insert after the step *)
}

val of_program : Program_names.t -> t
(** Generates [NAME_steps]. *)
