(** Makes a program show inner signals together with its output.

    Each requested signal becomes an additional output of its node, which is passed up from instance
    to instance to the root. For an instance in a loop, the output is an array. In a node that does
    not run in every instant, because it is a mode or inside [onEvent], the output is an [Event]
    that occurs only when the node runs; a signal that is already an event is not wrapped again.

    This happens before any optimization, so all signals still exist. The program's own behaviour
    does not change. *)

val program : Flow.Ir.program -> Catalogue.probe list -> Flow.Ir.program
(** The probes must be from the catalogue of this program. *)

val claims :
  shown:(Catalogue.probe -> bool) ->
  margin:(Basis.Span.t -> Core.Formula.t option) ->
  Catalogue.probe list ->
  Flow.Ir.claim list
(** A claim for each probe that is the verdict of an assertion. *)

val has_claims : Flow.Ir.program -> bool
(** Whether the program contains assertions. *)
