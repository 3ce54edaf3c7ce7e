(** What a program can be compiled from: a signal function or a program whose type is known
    to the end. Why another definition is no entry ([E0411]) is said here, before units and
    classes are gone, in the type that its signature has or would have. *)

val refusal : Ir.program -> closed:bool -> Ir.definition -> Basis.Diagnostic.t option
(** [None] if it is one. [closed]: no variable is left, perhaps since a robot closes it. *)
