(** The facts that Flow's checks report, as data without any message text. [Advice] translates each
    fact into a diagnostic.

    [entry] is the place of the program's definition, for {!Own_code}. *)

open Basis

(** {1 Loops within one instant} *)

type passage = { through : Ir.node; input : string; output : Ir.atom }
(** An instance that is part of a loop: to compute its output [output], its node [through] uses the
    input [input] in the same instant. *)

type hop = { reader : Ir.signal; read : Ir.signal; at : Span.t; via : passage list }
(** An edge of a loop: the definition of [reader] reads [read], at the place [at]. *)

type loop = {
  hops : hop list;
  named : bool;
      (** whether all signals of the loop are named. If so, the loop starts at the one that comes
          first in the source *)
  sums : Ir.sum array;
  run_by : (string * Span.t) option;
      (** for a loop in another module: the name and place of the instance in the entry's module
          that contains the loop, directly or indirectly *)
  entry : Span.t;
}

(** {1 Sizes} *)

type measure =
  | Values  (** values stored from one instant to the next *)
  | Instances  (** signal functions that run at the same time *)

type part = { whole : string; part : string; count : float; at : Span.t }
(** The definition [whole] contains [count] instances of [part], the first one at [at]. *)

(** {1 Chains of switches} *)

type step = {
  mode : int;  (** index into [program.nodes] of the mode that is left *)
  target : int;  (** index of the mode that is entered *)
  by : Ir.transition;
  source : (string * Span.t) option;
      (** the signal function whose event causes the transition, with its place *)
}
(** A transition that a mode may take in its first instant. *)

type t =
  | Loop of loop
  | Too_large of {
      entry : Span.t;
      measure : measure;
      amount : float;
      limit : float;
      largest : part list;  (** the path from the outermost definition to the largest part *)
    }
  | Endless of {
      at : Span.t;
      entry : Span.t;
      program : Ir.program;
      steps : step list;  (** a cycle *)
      limit : int option;
          (** present if the analysis could not prove a cycle, but the chain did not end within this
              number of steps *)
    }
