(** Assertions: [assert "label" condition] and [assume …] among the equations of a proc.

    Each is an equation like any other from here on, which defines the verdict on its condition
    (the library's [verdict], of a class) under a name that no source can mention. So nothing
    depends on it, and what no host asks for comes to nothing. *)

val verdict : Ir.Global.t
(** The method that tells what a condition says. *)

val name : Syntax.Ir.claim -> string -> string
(** Of the variable that is the verdict, from the label: [assert keeps off]. *)

val is_name : string -> bool
(** Is it such a name? *)

val label : string -> string option
(** What such a name was made of. *)

val is_assumption : string -> bool

val check : Scope.t -> Syntax.Ir.program -> unit
(** Emits E0234 for one that stands elsewhere, E0235 for a label that is no line of text. *)
