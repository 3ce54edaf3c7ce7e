(** Core as text, for dumps: the definitions of the main module.

    Variables keep their names; of several with one name in a definition the later ones get a
    number, and what has no name is [_1], [_2]…, so that the text does not depend on how many
    variables came before. Operators are written between their arguments. [x.Just.0] is a payload,
    [x.0] a component, [x ? Just] a test; [a and b] stands for [if a then b else False] and [not a]
    for [if a then False else True]; [@] goes before type arguments. *)

val program : Format.formatter -> Ir.program -> unit
val ty : Format.formatter -> Ir.ty -> unit

val type_name : Ir.ty -> string
(** On one line, as the programmer would write it: without units, and without the modules of names.
*)
