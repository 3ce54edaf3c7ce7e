(** The machines of modes, and how many modes an instant can take through. *)

open Basis

type machine = {
  name : string;  (** the definition that it is in *)
  file : string;
  span : Span.t;
  modes : string list;
  transitions : transition list;  (** mode by mode *)
  steps : int;  (** at most so many are stepped within one instant *)
}

and transition = {
  leaves : string;  (** a mode *)
  enters : string;
  at_entry : Flow.Ir.at_entry;  (** of the mode that it leaves *)
  at : Span.t;
}

val of_program : Step.Ir.program -> machine list
(** One for each machine in the code, callers before callees. *)
