(** Mistakes in the controls that a program requests from its operator. *)

open Basis

type problem =
  | Empty_label
  | Odd_character  (** the label contains this character, which is not allowed *)
  | Space_at_an_end
  | Long_label of { limit : int }
  | Unknown_label  (** the label is not known at compile time *)
  | Not_finite  (** the limits or the initial value of a knob *)
  | Limits of { least : float; most : float }  (** the limits are in the wrong order *)
  | Initial of { least : float; most : float; first : float }  (** outside the limits *)
  | Unknown_knob  (** numbers that are not known at compile time *)
  | Unknown_toggle  (** an initial position that is not known at compile time *)
  | Taken of { label : string; kind : Core.Ir.control_kind; by : Core.Ir.control }

type t = { at : Span.t; problem : problem }
