(** There are no instantaneous loops (language reference, section 6).

    For each mode of a machine this evaluates its first instant with the input
    unknown: delays have their initial value; times, integrals and derivatives
    are 0; numbers are ranges. So it finds the transitions that a mode may take
    at its own first instant. If they form a circle a chain of switches might
    never end; else the longest chain bounds how many modes an instant steps.

    A mode's parameter is the join of all that is passed for it, at any
    instant; after three rounds a bound that still moves is infinite. *)

val program : Basis.Diagnostic.sink -> Ir.program -> Ir.program
(** Emits [E0402] for each circle; fills in [steps] of machines and [at_entry] of
    their modes' transitions. For a causal program; a program without machines
    stays as it is. *)
