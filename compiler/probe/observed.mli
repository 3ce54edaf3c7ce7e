(** A program that shows inner signals beside its output.

    Each signal that is asked for becomes one more output of its node, handed up from instance to
    instance to the root. Of an instance in a loop it becomes an array. A node that does not run at
    each instant, as it is in a mode or in [onEvent], gives an [Event], which does not occur where
    the node does not run; where the signal is an event itself, that one.

    Made before anything is optimized, so every signal is there; and what the program does otherwise
    is as it was. *)

val program : Flow.Ir.program -> Catalogue.probe list -> Flow.Ir.program
(** The probes, of this program's catalogue. *)

val claims :
  shown:(Catalogue.probe -> bool) ->
  margin:(Basis.Span.t -> Core.Formula.t option) ->
  Catalogue.probe list ->
  Flow.Ir.claim list
(** Of the probes, those that are verdicts on assertions. *)

val has_claims : Flow.Ir.program -> bool
(** Is anything asserted in it? *)
