(** State machines, and the maximum number of modes that one instant can pass through. *)

open Basis

type machine = {
  name : string;  (** name of the definition that contains the machine *)
  file : string;
  span : Span.t;
  modes : string list;
  transitions : transition list;  (** ordered by the mode they leave *)
  steps : int;  (** maximum number of modes that run within one instant *)
}

and transition = {
  leaves : string;  (** name of a mode *)
  enters : string;
  at_entry : Flow.Ir.at_entry;
      (** whether the transition can occur in the first instant of the mode that it leaves *)
  at : Span.t;
}

val of_program : Step.Ir.program -> machine list
(** All machines in the code. The machines of callers precede those of callees. *)
