(** Derives the units of the members of generated structs from the program's types.

    A member of the state has the unit of the signal that it stores. A named signal has the type of
    the variable with that name; any other signal has the type of the expression at its place in the
    source. To the type checker, an angle is a plain number, so its unit comes from the declaration
    of its field. A value that is polymorphic in its unit gets no unit. *)

val of_program :
  resolved:Resolve.Ir.program -> Typing.Ir.program -> Typing.Ir.definition -> Cgen.Units.t
(** The definition is the program's entry, as the source declares it. *)
