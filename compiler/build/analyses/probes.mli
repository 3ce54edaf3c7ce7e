(** The inner signals of a program that the user wants to see.

    Reports [E0506] if there is no signal with a requested name. *)

open Basis

val name_of : Typing.Ir.definition -> Basis.Span.t
(** The place of an entry's name in its definition. *)

val unknown : string
(** The code of the diagnostic for an unknown name. *)

val claims : string
(** The probe name that selects the verdicts of all assertions. *)

val list : Typing.Ir.program -> Flow.Ir.program -> Probe.Catalogue.probe list -> string
(** A line for each probe: its name, its type, and its place in the source. *)

val all :
  Diagnostic.sink ->
  Typing.Ir.definition ->
  Core.Ir.program ->
  Flow.Ir.program ->
  Probe.Catalogue.probe list option
(** All probes of a program. The arguments are the program before and after specialization. [None]
    after an error, which is reported at the entry's name. *)

val named :
  Diagnostic.sink ->
  Typing.Ir.definition ->
  Core.Ir.program ->
  Flow.Ir.program ->
  asserts:bool ->
  string list ->
  (Probe.Catalogue.probe * bool) list option
(** The probes that {!Probe.Selection} finds for these names. If [asserts] is true, also returns the
    verdicts of assertions. The Boolean says whether one of the names selects the probe. *)

val causal :
  Flow.Ir.program ->
  Probe.Catalogue.probe list ->
  Probe.Catalogue.probe list * Probe.Catalogue.probe list
(** Splits probes into a maximal set of probes that can be shown together, and the rest. All outputs
    of a switch depend on every input that any of its signal functions reads. Showing an input that
    was not read before may therefore make a signal depend on itself within an instant. *)

val warn_of_claims :
  Diagnostic.sink -> Typing.Ir.definition -> Core.Ir.program -> Flow.Ir.program -> unit
(** Reports W0311 for each assertion that cannot be checked. *)

val refuse_hidden :
  Diagnostic.sink ->
  Typing.Ir.definition ->
  names:string list ->
  Probe.Catalogue.probe list ->
  unit option
(** Reports probes that cannot be shown: W0311 for each assertion, and an error for a signal that
    the user named. [None] after an error. *)
