(** The tests and trials of a module, with what is known of them before they run.

    Code: [E0392] what a test or trial is to do makes no sense, or is not known. *)

open Basis

type trial = {
  world : string;  (** as it is written *)
  first : int;
  last : int;  (** seeds *)
  chance : Chance.t option;
}

type plan =
  | Alone  (** a signal function without input *)
  | Traced of { input : string; output : string }  (** files, as they are written *)
  | Simulated of trial

type t = {
  name : string;  (** of the definition *)
  label : string;
  lasts : float;  (** seconds *)
  plan : plan;
}

val of_program : Diagnostic.sink -> Core.Ir.program -> t list
(** Of its main module, in the order of the text. *)
