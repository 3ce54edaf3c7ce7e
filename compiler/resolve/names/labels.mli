(** Assertions and tests, and the names of the definitions that they create.

    Assertions are [assert "label" condition] and [assume …] among the equations of a proc. Name
    resolution turns each of them into an ordinary equation that defines the verdict on its
    condition (using the library's class method [verdict]) under a name that cannot occur in source
    code. Nothing depends on this equation, so it is removed unless a host needs the verdict.

    [test "label" = e] and [trial "label" = e] define values of the library types [Test] and
    [Trial], under names that cannot occur in source code. The judge in each test is a separate
    definition, from which a program can be compiled. *)

val verdict : Ir.Global.t
(** The method that computes the verdict on a condition. *)

val name : Syntax.Ir.claim -> string -> string
(** The name of the verdict variable for a label, for example [assert keeps off]. *)

val is_name : string -> bool
(** Is this the name of a verdict? *)

val label : string -> string option
(** The label in the name of a verdict. *)

val is_assumption : string -> bool
val word : Syntax.Ir.claim -> string

val check_name : Syntax.Ir.check -> string -> string
(** The name of the definition for the test with this label. *)

val judge : string -> string
(** The name of the judge's definition, given the name of the test's definition. *)

val is_measuring : Ir.Global.t -> bool
(** Does [frobc test] report the value of an equation that applies this library function, such as
    [error = meanOf x]? *)

val kind_of_check : string -> (Syntax.Ir.check * string) option
(** The kind and label of a test, if this is the name of one. *)

val holding : Ir.Global.t
(** The library function that turns a condition into a test. The compiler applies it to the value of
    each [test], and type inference removes it from values that are already tests. *)

val qualifier : string
(** The qualifier of the names in {!import}. *)

val import : Syntax.Ir.program -> Syntax.Ir.import option
(** The import that is added for the tests of a program. The program itself cannot refer to the
    imported names. *)

val checked : Syntax.Ir.declaration -> (Syntax.Ir.name * Syntax.Ir.expr) list
(** The definitions that a test declaration creates; empty for other declarations. *)

val check_signature : Syntax.Ir.declaration -> (Syntax.Ir.name * Syntax.Ir.qualified_type) list
