(** Chooses the {!Program_names}, and looks up the names and the types of parts of the program. *)

val of_program :
  ?own:Robot.t -> ?units:Units.t -> ?named:Named_constants.t -> Step.Ir.program -> Program_names.t
(** [own]: the user's own robot, if the program is for one. *)

val home : Program_names.t -> int -> int
(** The node whose struct contains the state of this node. *)

val state_struct : Program_names.t -> int -> string
(** The struct that contains the state of this node. *)

val ty : Program_names.t -> Step.Ir.ty -> Ir.ty
val absent : Program_names.t -> Flow.Ir.foreign_type -> Ir.expr

val zero : Program_names.t -> Step.Ir.ty -> Ir.expr
(** An arbitrary initial value. *)

val real : Program_names.t -> Ir.ty
(** The type of a Float. *)

val float : Program_names.t -> float -> Ir.expr
(** A literal. Negative zero is written as a function call; [<frob/step.h>] explains why. *)

val literal : Program_names.t -> at:Basis.Span.t -> float -> Ir.expr
(** An operand of the operation at this place: the name of a constant if the programmer used one,
    otherwise the literal. *)

val is_negative_zero : float -> bool

val in_precision : Program_names.t -> string -> string
(** The name of this function from [<frob/step.h>] in the program's precision. *)

val call : Program_names.t -> string -> Ir.expr list -> Ir.expr
(** Calls a function from [<frob/step.h>] or [<math.h>] on Floats, in the program's precision. *)

val elementary : Core.Primitive.elementary -> string
(** The C function for doubles. The square root is the one from [<math.h>], which is correctly
    rounded on every machine. *)

val maker : Program_names.t -> sum:int -> constructor:int -> string
val projection : Program_names.t -> sum:int -> constructor:int -> leaf:int -> string

val array_function : Program_names.t -> Array_type.operation -> Step.Ir.ty -> string
(** The function for an operation on an array type. *)

val take_pending : Program_names.t -> Ir.function_ list
(** The helpers needed since the last call. *)

val is_root : Program_names.t -> int -> bool
val has_state : Program_names.t -> int -> bool

val has_modes : Program_names.t -> bool
(** Whether the program has a machine with more than one mode. *)
