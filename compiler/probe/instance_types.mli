(** The types of signals in the instances of a program.

    {!Signal_types} keeps the type variables of a polymorphic signal function, such as [u] in
    [lowPass :: Float[s] -> SF Float[u] Float[u]]. This module replaces them with the values that
    each use of the function determines: [u] is [m] in [lowPass 1[s] (frontSonar i)]. *)

type t

val of_program : Typing.Ir.program -> Flow.Ir.program -> t

val type_of : t -> Catalogue.probe -> Typing.Ir.ty option
(** Like {!Signal_types.type_of}. A variable remains in the type if the program does not determine
    its value, or if this module does not find the use that determines it. *)
