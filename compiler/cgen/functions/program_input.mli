(** Which functions read the program's input by the pointer that the root's step is given.

    A node's step that is called in few places often gets members of the program's input there, just
    as they came. Where it gets at least three so, it is given the pointer instead, and reads
    [in->side] as a person would: that takes less code than handing over each member, through all
    functions between. *)

type t

val of_program : Step.Ir.program -> Interface.t -> t
(** The interface is that of the program's input. *)

val is_given : t -> int -> bool
(** Whether that node's step gets the pointer. *)

val member : t -> int -> Step.Ir.variable -> Interface.step list option
(** What leads to a parameter of that node's step from the pointer, if it is read there. *)

val variables_by_pointer :
  t -> Step.Ir.program -> Step.Ir.node -> Step.Ir.statement list -> Step.Ir.variable list
(** What this body of the node's hands over by the pointer, once for each call that reads it there.
*)
