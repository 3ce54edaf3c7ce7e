(** The report as one JSON object.

    - [program]
    - [entry]: [name], [file], [line]
    - [state_bytes]
    - [structs], beginning with the root's struct: each has [name], [file], [line], [bytes] and
      [members]. A member has [name], [line], [offset], [bytes] and [holds], which is [value] (with
      [purpose]), [struct] (with [struct], an index into [structs]), [structs] (an array: with
      [struct] and [count]), or [mode] or [modes] (with [modes], each having [name], [bytes],
      [members])
    - [step_operations]: the operations by kind, with [calls] by elementary function
    - [reset_stack_bytes], [step_stack_bytes]
    - [library]: the functions of the C library that the program calls
    - [machines]: [name], [file], [line], [modes], [steps] and [transitions]. A transition has
      [from], [to], [line], [at_first_instant] (whether it may occur in the first instant of the
      mode it leaves) and, if not, [event] (the signal function that causes it)
    - [assertions]: the number of assertions; [assertion_operations] and [assertion_bytes]: the
      operations that checking them adds to a step, and the bytes it adds to the state *)

val to_string : ?judged:Judged.t -> ?wire:Wire.t -> Bounds.t -> string
(** The text does not end with a line feed. *)
