(** Assertions and tests, and how what they define is called.

    Assertions: [assert "label" condition] and [assume …] among the equations of a proc.

    Each is an equation like any other from here on, which defines the verdict on its condition (the
    library's [verdict], of a class) under a name that no source can mention. So nothing depends on
    it, and what no host asks for comes to nothing.

    [test "label" = e] and [trial "label" = e] are definitions of the types [Test] and [Trial] of
    the library, under names that no source can mention; and the judge in each is one more
    definition, that a program can be compiled from. *)

val verdict : Ir.Global.t
(** The method that tells what a condition says. *)

val name : Syntax.Ir.claim -> string -> string
(** Of the variable that is the verdict, from the label: [assert keeps off]. *)

val is_name : string -> bool
(** Is it such a name? *)

val label : string -> string option
(** What such a name was made of. *)

val is_assumption : string -> bool
val word : Syntax.Ir.claim -> string

val check_name : Syntax.Ir.check -> string -> string
(** Of the definition that a test is, from its label. *)

val judge : string -> string
(** Of the definition that is the judge in it, from its name. *)

val is_measuring : Ir.Global.t -> bool
(** Is it one of the library's functions whose values [frobc test] tells, where an equation names
    them, as [error = meanOf x] does? *)

val kind_of_check : string -> (Syntax.Ir.check * string) option
(** Kind and label, if a definition of that name is a test. *)

val checked : Syntax.Ir.declaration -> (Syntax.Ir.name * Syntax.Ir.expr) list
(** What a test defines; nothing if it is none. *)

val check_signature : Syntax.Ir.declaration -> (Syntax.Ir.name * Syntax.Ir.qualified_type) list
