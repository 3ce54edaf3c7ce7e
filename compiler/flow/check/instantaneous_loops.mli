(** There are no instantaneous loops (language reference, section 6).

    If the transitions that modes of a machine may take at their own first instant (see
    {!First_transitions}) form a circle a chain of switches might never end; else the longest chain
    bounds how many modes an instant steps. *)

val program : Basis.Diagnostic.sink -> entry:Basis.Span.t -> Ir.program -> Ir.program
(** Emits [E0402] for each circle; fills in [steps] of machines and [at_entry] of their modes'
    transitions. For a causal program; a program without machines stays as it is. The entry is where
    the program is defined: a circle in the library is shown with what the program has it do. *)
