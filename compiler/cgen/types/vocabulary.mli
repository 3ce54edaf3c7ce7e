(** The file-level names of one program, all chosen at once, and what of the program's types and
    helpers the code turns out to need. *)

type mode = { constant : string;  (** its number *) member : string  (** of the union of all *) }

type node = {
  state : string;  (** struct *)
  reset : string;
  step : string;
  members : string list Basis.Int_table.t;  (** that lead to fields from the state struct *)
  modes : mode array;  (** of its machine *)
  foreign : Foreign_interface.t option;  (** if it is C code of the user's *)
}

(** A small function on values of one type, called somewhere. *)
type helper =
  | Maker of { sum : int; constructor : int }
  | Projection of { sum : int; constructor : int; leaf : int }
  | On_arrays of Array_type.operation * Step.Ir.ty

type t = {
  program : Step.Ir.program;
  name : string;  (** the prefix of all names *)
  file_scope : Name.scope;
  types : Value_types.t;
  foreign_types : Value_types.t;  (** as C code of the user's has them *)
  sums : Sum_type.t array;  (** the program's own *)
  nodes : node array;
  in_seconds : string;  (** the root's step whose dt is in seconds *)
  input : Interface.t;
  output : Interface.t;
  params : Param_struct.t option;  (** which functions get as a pointer, [params] *)
  param_use : Step.Param_use.t;
  by_pointer : Program_input.t;  (** steps that read the input there *)
  records : Ir.declaration list;  (** the program's own interface structs *)
  robot_records : Ir.declaration list;  (** those of a robot's header *)
  foreign_records : Ir.declaration list;  (** those that C code of the user's knows *)
  imports : Foreign_interface.t list;
  robots : Robot.t list;  (** whose headers are needed *)
  helpers : (helper, string) Hashtbl.t;
  mutable pending : Ir.function_ list;  (** last first *)
  absent : (Flow.Ir.foreign_type, string) Hashtbl.t;
      (** variables that stand for values that are not there *)
}

val of_program : ?own:Robot.t -> Step.Ir.program -> t
(** [own]: the user's own robot, if the program is for one. *)

val ty : t -> Step.Ir.ty -> Ir.ty
val absent : t -> Flow.Ir.foreign_type -> Ir.expr

val zero : t -> Step.Ir.ty -> Ir.expr
(** Some value, as an initial value. *)

val real : t -> Ir.ty
(** Of a Float. *)

val float : t -> float -> Ir.expr

val call : t -> string -> Ir.expr list -> Ir.expr
(** Of a function of [<frob/step.h>] or [<math.h>] on Floats, in the program's precision. *)

val elementary : Core.Primitive.elementary -> string
(** The C function of doubles; the square root is [<math.h>]'s, as exact everywhere. *)

val maker : t -> sum:int -> constructor:int -> string
val projection : t -> sum:int -> constructor:int -> leaf:int -> string

val array_function : t -> Array_type.operation -> Step.Ir.ty -> string
(** Of an array type. *)

val take_pending : t -> Ir.function_ list
(** The helpers that were asked for since the last time. *)

val is_root : t -> int -> bool
val has_state : t -> int -> bool

val has_modes : t -> bool
(** Whether there is a machine of more than one mode. *)
