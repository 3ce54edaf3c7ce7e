(** Checks that there are no instantaneous loops (language reference, section 6).

    If the transitions that modes of a machine may take in their first instants (see
    {!First_transitions}) form a cycle, a chain of switches might never end. Otherwise, the longest
    chain bounds the number of modes that run in one instant. *)

val program : Fact.t Basis.Facts.t -> entry:Basis.Span.t -> Ir.program -> Ir.program
(** Reports each cycle. Fills in the [steps] of each machine and the [at_entry] of its modes'
    transitions. The program must be causal; a program without machines is returned unchanged.
    [entry] is the place of the program's definition. A cycle inside the library is reported where
    the program uses the library. *)
