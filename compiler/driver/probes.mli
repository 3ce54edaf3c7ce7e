(** The inner signals of a program that a user asks to see.

    Code: [E0506] there is none of that name. *)

open Basis

val unknown : string
(** The code. *)

val list : Typing.Ir.program -> Flow.Ir.program -> Probe.Catalogue.probe list -> string
(** A line for each: its name, its type, and where it is written. *)

val all :
  Diagnostic.sink -> at:Span.t -> Core.Ir.program -> Flow.Ir.program -> Probe.Catalogue.probe list
    option
(** Of the same program, before and after specialization; [None] after a diagnostic, which is at
    the entry. *)

val named :
  Diagnostic.sink ->
  at:Span.t ->
  Core.Ir.program ->
  Flow.Ir.program ->
  string list ->
  Probe.Catalogue.probe list option
(** Of these, those that {!Probe.Selection} takes the names for. *)
