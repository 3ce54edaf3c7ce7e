(** The file-level names of a program, which are all chosen in advance, and the types and helpers
    that the generated code uses. *)

type mode = { constant : string;  (** its number *) member : string  (** of the modes' union *) }

type member = {
  name : string;
  stores : Step.State_struct.member;
  modes : (string * member list) list;  (** the structs of a union, with their names in the union *)
}
(** A member of a state struct. *)

type node = {
  state : string;  (** its struct; [""] if it has no struct of its own *)
  reset : string;
  step : string;
  members : member list;  (** the members of its struct *)
  paths : string list Basis.Int_table.t;
      (** paths to the node's fields, by id, in the struct that contains them *)
  modes : mode array;  (** modes of its machine *)
  foreign : Foreign_interface.t option;  (** present for a node implemented by the user's C *)
}

(** A small helper function on values of one type. *)
type helper =
  | Maker of { sum : int; constructor : int }
  | Projection of { sum : int; constructor : int; leaf : int }
  | On_arrays of Array_type.operation * Step.Ir.ty

type t = {
  program : Step.Ir.program;
  structs : Step.State_struct.t;
  units : Units.t;
  named : Named_constants.t;
  name : string;  (** the prefix of all names *)
  file_scope : Name.scope;
  types : Value_types.t;
  foreign_types : Value_types.t;  (** types for the user's C *)
  sums : Sum_type.t array;  (** the program's own sums *)
  nodes : node array;
  in_seconds : string;  (** name of the root's step that takes dt in seconds and rounds it *)
  input : Interface.t;
  output : Interface.t;
  params : Param_struct.t option;  (** parameters; functions receive a pointer [params] to them *)
  param_use : Step.Param_use.t;
  dt_limits : Step.Dt_limits.t;
  by_pointer : Program_input.t;  (** steps that read the input through the pointer *)
  records : Ir.declaration list;  (** the program's own interface structs *)
  robot_records : Ir.declaration list;  (** structs of a robot's header *)
  foreign_records : Ir.declaration list;  (** structs that the user's C uses *)
  imports : Foreign_interface.t list;
  robots : Robot.t list;  (** robots whose headers are included *)
  helpers : (helper, string) Hashtbl.t;
  mutable pending : Ir.function_ list;  (** helpers not yet emitted, last one first *)
  absent : (Flow.Ir.foreign_type, string) Hashtbl.t;
      (** variables whose addresses are placeholders for missing values *)
  constants : (Named_constants.constant, string * float) Hashtbl.t;
      (** the constants that the code uses, with their names and values in C *)
}

val of_program : ?own:Robot.t -> ?units:Units.t -> ?named:Named_constants.t -> Step.Ir.program -> t
(** [own]: the user's own robot, if the program is for one. *)

val home : t -> int -> int
(** The node whose struct contains the state of this node. *)

val state_struct : t -> int -> string
(** The struct that contains the state of this node. *)

val ty : t -> Step.Ir.ty -> Ir.ty
val absent : t -> Flow.Ir.foreign_type -> Ir.expr

val zero : t -> Step.Ir.ty -> Ir.expr
(** An arbitrary initial value. *)

val real : t -> Ir.ty
(** The type of a Float. *)

val float : t -> float -> Ir.expr
(** The literal. Negative zero is a function call; [<frob/step.h>] explains why. *)

val literal : t -> at:Basis.Span.t -> float -> Ir.expr
(** An operand of the operation at this place: the name of a constant, or the literal. *)

val is_negative_zero : float -> bool

val in_precision : t -> string -> string
(** The name of a function of [frob/step.h] for the program's precision. *)

val call : t -> string -> Ir.expr list -> Ir.expr
(** Calls a function of [<frob/step.h>] or [<math.h>] on Floats, in the program's precision. *)

val elementary : Core.Primitive.elementary -> string
(** The C function for doubles. The square root is the one from [<math.h>], which is exact on every
    machine. *)

val maker : t -> sum:int -> constructor:int -> string
val projection : t -> sum:int -> constructor:int -> leaf:int -> string

val array_function : t -> Array_type.operation -> Step.Ir.ty -> string
(** The function for an operation on an array type. *)

val take_pending : t -> Ir.function_ list
(** The helpers that were needed since the last call. *)

val is_root : t -> int -> bool
val has_state : t -> int -> bool

val has_modes : t -> bool
(** Whether the program has a machine with more than one mode. *)
