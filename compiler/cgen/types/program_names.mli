(** The file-level names of a program, and the types and helpers that the generated code uses. All
    names are chosen before any code is generated. *)

type mode = {
  constant : string;  (** its number *)
  member : string;  (** name of the mode's struct in the union of all modes *)
}

type member = {
  name : string;
  stores : Step.State_struct.member;
  modes : (string * member list) list;  (** the structs in a union, with their member names *)
}
(** A member of a state struct. *)

type node = {
  state : string;  (** name of its state struct; [""] if it has no struct of its own *)
  reset : string;
  step : string;
  members : member list;  (** the members of its struct *)
  paths : string list Basis.Int_table.t;
      (** paths to the node's fields within the struct that contains them, by id *)
  modes : mode array;  (** modes of its machine *)
  foreign : Foreign_interface.t option;  (** present for a node implemented by the user's C code *)
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
  name : string;  (** the prefix of all file-level names *)
  file_scope : Name.scope;
  types : Value_types.t;
  foreign_types : Value_types.t;  (** value types for the user's C code *)
  sums : Sum_type.t array;  (** the program's own sums *)
  nodes : node array;
  in_seconds : string;  (** name of the root's step that takes dt in seconds and rounds it *)
  is_valid : string;  (** name of the function that checks the state *)
  input : Interface.t;
  output : Interface.t;
  params : Param_struct.t option;
      (** the parameters; functions receive a pointer [params] to them *)
  param_use : Step.Param_use.t;
  dt_limits : Step.Dt_limits.t;
  by_pointer : Program_input.t;  (** steps that read the input through the pointer *)
  records : Ir.declaration list;  (** the program's own interface structs *)
  robot_records : Ir.declaration list;  (** structs of a robot's header *)
  foreign_records : Ir.declaration list;  (** structs that the user's C code uses *)
  imports : Foreign_interface.t list;
  robots : Robot.t list;  (** robots whose headers are included *)
  helpers : (helper, string) Hashtbl.t;
  mutable pending : Ir.function_ list;  (** helpers not yet emitted, newest first *)
  absent : (Flow.Ir.foreign_type, string) Hashtbl.t;
      (** variables whose addresses are placeholders for missing values *)
  constants : (Named_constants.constant, string * float) Hashtbl.t;
      (** the constants that the code uses, with their names and values in C *)
}
