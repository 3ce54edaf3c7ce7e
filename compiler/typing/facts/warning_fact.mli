(** Facts reported by the checks for suspicious code in a typed program. *)

(** A requirement of the function or record [of_] that a constant does not meet. *)
type unmet =
  | Negative_time
  | Negative
  | Below of float  (** the constant must be at least this number *)
  | Not_above of float
  | Above of float  (** the constant must be at most this number *)
  | Zero_sum  (** the sum of its elements is 0 *)

type unwrap =
  | Around of Ir.expr option  (** the angle to which [unwrap] can be applied, if there is one *)
  | Before of Ir.expr  (** [unwrap] can be composed with this signal function *)

type t =
  | Not_a_number of Ir.expr  (** a constant that is NaN *)
  | Wraps_around of { constant : Ir.expr; value : int }
      (** an Int whose exact value, [value], is out of range *)
  | Step_division of Ir.expr  (** a division by the length of the step *)
  | Unmet of { of_ : string; argument : Ir.expr; unmet : unmet }
  | Swapped_limits of { of_ : string; low : Ir.expr; high : Ir.expr }
  | Limits_cross of { limit : Ir.expr; other : Ir.expr }
      (** nested [min] and [max], whose result is always [limit] *)
  | Limited_constant of { low : Ir.expr; high : Ir.expr; limited : Ir.expr }
      (** [clamp] of a constant, with a lower limit that is not constant *)
  | Unreachable_threshold of {
      comparison : Ir.expr;
      result : bool;  (** its constant result *)
      robot : string;
      sensor : string;
      reach : float;  (** the largest possible reading, in metres *)
    }
  | Angle_difference of {
      resolved : Resolve.Ir.program;
      difference : Ir.expr;
      left : Ir.expr;
      right : Ir.expr;
    }  (** the difference between two angles that wrap *)
  | Wrapped_angle of {
      resolved : Resolve.Ir.program;
      function_ : Ir.Global.t;
      head : Ir.expr;  (** the expression that refers to the function *)
      angle : Ir.expr;  (** an angle that wraps, or a multiple of one *)
      scaled : bool;  (** whether [angle] is a multiple of such an angle *)
      instead : string;  (** name of the function to use for angles that wrap *)
      module_ : string;  (** the module of that function *)
      same_arguments : bool;  (** whether it takes the same arguments *)
      unwrap : unwrap;
    }  (** a function that is not suitable for angles that wrap *)
