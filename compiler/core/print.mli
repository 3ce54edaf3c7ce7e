(** Prints the definitions of the main module, for dumps of Core.

    Variables keep their names. If several variables of a definition share a name, the later ones
    get a number. Unnamed variables are printed as [_1], [_2]…, so that the text does not depend on
    how many variables were created before. Operators are infix. [x.Just.0] is a payload, [x.0] a
    component, [x ? Just] a test. [a and b] represents [if a then b else False], and [not a]
    represents [if a then False else True]. Type arguments follow [@]. *)

val program : Format.formatter -> Ir.program -> unit
val ty : Format.formatter -> Ir.ty -> unit

val type_name : Ir.ty -> string
(** The type on one line, in source syntax, without units and without module qualifiers. *)
