(** The machines of modes, and how many modes an instant can take through. *)

open Basis

type machine = {
  name : string;  (** the definition that it is in *)
  file : string;
  span : Span.t;
  modes : string list;
  steps : int;  (** at most so many are stepped within one instant *)
}

val of_program : Machine.Ir.program -> machine list
(** One for each machine in the code, callers before callees. *)
