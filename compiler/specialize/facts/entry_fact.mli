(** Programs that cannot run, although they are well typed. *)

open Basis

type part = Input | Output | Result

type t =
  | Interface of { definition : Core.Ir.definition; part : part; ty : Core.Ir.ty }
      (** this part of the definition's interface contains functions or labels *)
  | Different_results of Core.Ir.definition
      (** a choice between programs whose results have different types *)
  | Needs_itself of Core.Ir.Local.t  (** a function that depends on itself *)
  | Rate of { at : Span.t; rate : float option; slowest : float; fastest : float }
      (** the rate of a node is unknown at compile time, or outside these limits, in Hz *)
