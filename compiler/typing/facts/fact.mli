(** A fact that type checking reports, as data; [Advice] adds the text of the message. [Advice]
    turns it into a diagnostic. *)

open Basis

(** A construct whose type can be too large. *)
type construct = Expression | Field | Instance | Declaration of string | Definition of string

type t =
  | Pattern of Pattern_fact.t
  | Level of Level_fact.t
  | Warning of Warning_fact.t
  | Declaration of { around : Surroundings.t; fact : Declaration_fact.t }
  | Inference of { around : Surroundings.t; fact : Inference_fact.t }
  | Instance of { around : Surroundings.t; fact : Instance_fact.t }
  | Misapplied of { around : Surroundings.t; call : Application_fact.call; mistake : t Facts.held }
      (** the application as a whole may explain the mistake in one of its arguments *)
  | Called_as_method of {
      around : Surroundings.t;
      call : Application_fact.method_call;
      mistake : t Facts.held;  (** the array does not have this field *)
    }
  | Refutable_input of {
      pattern : Resolve.Ir.pattern;  (** [()] *)
      input : Type.t;
      mistake : t Facts.held;  (** the mismatch *)
    }  (** the pattern [()] for a value of another type *)
  | Exchanged_signature of {
      around : Surroundings.t;
      fact : Signature_fact.t;
      mistakes : t Facts.held list;
          (** the mistakes in the definition, assuming that the signature is right; not empty *)
    }
  | Scaled_power of { at : Span.t; unit_ : Ir.Global.t; exponent : Rational.t }
      (** a scaled unit raised to a power that is not an integer *)
  | Scaled_unit_in_type of {
      environment : Environment.t;
      places : Span.t list;  (** all occurrences on one line; not empty *)
      measure : Units.t;  (** the unit in base units *)
    }
  | Array_size of { at : Span.t; size : int; largest : int }  (** a size out of range *)
  | Wrong_kind of { environment : Environment.t; at : Span.t; wanted : Type.kind; found : Type.t }
      (** a size in place of a type, or the reverse *)
  | Too_many_updates of { at : Span.t; record : Ir.constructor; updates : int; most_fields : int }
      (** the record updates up to this place write too many fields; [record] accounts for the
          largest share, with [updates] updates *)
  | Entry of Entry_fact.t
  | Too_large of { at : Span.t; construct : construct }  (** see {!Final.Too_large} *)
  | Exponent_too_large of Span.t  (** the exponent of a unit *)
