(** The tests and trials of a module, with everything that is known before they run.

    Reports [E0392] if the description of a test or trial is invalid, or cannot be computed before
    the run. *)

open Basis

type trial = {
  world : string;  (** the name or file of the world, as written in the program *)
  first : int;
  last : int;  (** first and last seed *)
  chance : Chance.t option;
}

type plan =
  | Alone  (** a signal function without input *)
  | Traced of { input : string; output : string }  (** file names as written in the program *)
  | Simulated of trial

type t = {
  name : string;  (** name of the definition *)
  label : string;
  lasts : float;  (** seconds *)
  plan : plan;
}

val of_program : Diagnostic.sink -> Core.Ir.program -> t list
(** The tests and trials of the main module, in source order. *)
