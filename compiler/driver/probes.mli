(** The inner signals of a program that a user asks to see.

    Code: [E0506] there is none of that name. *)

open Basis

val name_of : Typing.Ir.definition -> Basis.Span.t
(** Where an entry is defined: its name. *)

val unknown : string
(** The code. *)

val claims : string
(** What all verdicts on assertions are called, as one probe. *)

val margins : string
(** And all that says how nearly they held. *)

val list : Typing.Ir.program -> Flow.Ir.program -> Probe.Catalogue.probe list -> string
(** A line for each: its name, its type, and where it is written. *)

val all :
  Diagnostic.sink ->
  Typing.Ir.definition ->
  Core.Ir.program ->
  Flow.Ir.program ->
  Probe.Catalogue.probe list option
(** Of the same program, before and after specialization; [None] after a diagnostic, which is at the
    name of the entry. *)

val named :
  Diagnostic.sink ->
  Typing.Ir.definition ->
  Core.Ir.program ->
  Flow.Ir.program ->
  asserts:bool ->
  string list ->
  (Probe.Catalogue.probe * bool) list option
(** Of these, those that {!Probe.Selection} takes the names for; and with [asserts] the verdicts on
    assertions too, with whether they are meant by a name. *)

val causal :
  Typing.Ir.definition ->
  Flow.Ir.program ->
  Probe.Catalogue.probe list ->
  Probe.Catalogue.probe list * Probe.Catalogue.probe list
(** As many as can be shown together, and the others. All outputs of a switch need what any of its
    signal functions reads, so one that is shown an input that was not read before may come to need
    its own output of the same instant. *)

val warn_of_claims :
  Diagnostic.sink -> Typing.Ir.definition -> Core.Ir.program -> Flow.Ir.program -> unit
(** Emits W0311 for each assertion that cannot be watched. *)

val refuse_hidden :
  Diagnostic.sink ->
  Typing.Ir.definition ->
  names:string list ->
  Probe.Catalogue.probe list ->
  unit option
(** [None] after a diagnostic, if one that was asked for by its name cannot be shown. Emits W0311
    for an assertion. *)
