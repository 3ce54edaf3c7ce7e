(** Replaces signals of a node with equal atoms.

    A pass collects replacements and finally applies them to the whole node. Replacements may be
    chained. Replaced signals lose their definitions. *)

type t

val create : unit -> t

val replace : t -> Ir.signal -> Ir.atom -> unit
(** Records that an atom replaces a signal. If the programmer named the signal and the atom is an
    unnamed signal, the atom inherits the name. *)

val atom : t -> Ir.atom -> Ir.atom

val is_empty : t -> bool
(** Whether no replacement has been recorded. *)

val node : t -> Ir.node -> Ir.node
(** Removes the equations of replaced signals and replaces the operands of the others. Keeps all
    outputs of instances, even unused ones. *)
