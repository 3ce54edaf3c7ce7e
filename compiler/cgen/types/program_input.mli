(** Determines which functions read the program's input through the pointer that the root's step
    receives.

    A node's step often receives members of the program's input unchanged from all its callers. If
    it receives at least three of them, it gets the pointer to the input instead, and reads
    [in->side], as handwritten code would. This takes less code than passing each member through all
    functions in between. *)

type t

val of_program : Step.Ir.program -> Interface.t -> t
(** The interface must belong to the program's input. *)

val is_given : t -> int -> bool
(** Whether the step of this node receives the pointer. *)

val member : t -> int -> Step.Ir.variable -> Interface.step list option
(** The path from the pointer to a parameter of this node's step, if the step reads it through the
    pointer. *)

val reads_only_elements :
  Step.Ir.statement list ->
  Step.Ir.variable ->
  Interface.step list ->
  by_pointer:Step.Ir.variable list ->
  bool
(** Whether a body reads an array with this path only element by element, never as a whole.
    [by_pointer]: the variables that the body passes through the pointer; see
    {!variables_by_pointer}. *)

val variables_by_pointer :
  t -> Step.Ir.program -> Step.Ir.node -> Step.Ir.statement list -> Step.Ir.variable list
(** The variables that a body of this node passes through the pointer. Each occurs once for every
    call whose callee reads it through the pointer. *)
