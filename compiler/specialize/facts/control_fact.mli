(** Mistakes in the controls that a program requests from its operator. *)

open Basis

type problem =
  | Empty_label
  | Odd_character  (** the label contains a character that is not allowed *)
  | Space_at_an_end
  | Long_label of { limit : int }
  | Unknown_label  (** the label is not known at compile time *)
  | Not_finite  (** a limit or the initial value of a knob is not finite *)
  | Limits of { least : float; most : float }  (** the limits are in the wrong order *)
  | Initial of { least : float; most : float; first : float }
      (** the initial value is outside the limits *)
  | Unknown_knob  (** a limit or the initial value is not known at compile time *)
  | Unknown_toggle  (** the initial position is not known at compile time *)
  | Taken of { label : string; kind : Core.Ir.control_kind; by : Core.Ir.control }

type t = { at : Span.t; problem : problem }
