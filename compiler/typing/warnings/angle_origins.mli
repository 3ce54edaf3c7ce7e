(** Finds the origins of angles that wrap from pi to -pi: the heading of a [Pose] or an [Imu], and
    the results of functions whose doc comment says that the result wraps ({!Doc_facts}). *)

type t

val of_program : Doc_facts.t -> Resolve.Ir.program -> Ir.program -> t

type kind =
  | Heading
  | Rotation  (** from one heading to another, so small differences are fine *)
  | Scaled  (** a dimensionless multiple of a heading, such as its value in degrees *)

val kind : t -> Ir.expr -> kind option
(** The kind of angle, if the value of the expression or an element of that value is an angle that
    wraps; otherwise [None]. Follows equations, and functions that return their argument. *)

val output : t -> Ir.expr -> kind option
(** Like {!kind}, for the output of a signal function, which may be a composition. *)

val within : t -> Ir.expr -> Ir.expr
(** The angle itself, if the expression is a multiple of an angle, or runs a signal function that
    passes an angle on, such as [delay]. *)

val is_heading : Ir.constructor -> int -> bool
(** Is this field the heading of a [Pose] or an [Imu]? *)

val called : Ir.expr -> (Resolve.Ir.Global.t * Ir.expr list) option
(** The function or primitive that an expression applies, with its arguments. *)
