(** The file-level names of one program, all chosen at once, and what of the
    program's types and helpers the code turns out to need. *)

type mode = {
  constant : string;  (** its number *)
  member : string;  (** of the union of all *)
}

type node = {
  state : string;  (** struct *)
  reset : string;
  step : string;
  members : (int, string list) Hashtbl.t;
      (** the members that lead to a field from the state struct, by field *)
  modes : mode array;  (** of its machine *)
}

type t = {
  program : Machine.Ir.program;
  name : string;  (** the prefix of all names *)
  file_scope : Name.scope;
  sums : Sum_type.t array;
  foreign : bool array;  (** sums that a robot's header defines *)
  nodes : node array;
  input : Interface.t;
  output : Interface.t;
  records : Ir.declaration list;  (** the program's own interface structs *)
  robot_records : Ir.declaration list;  (** those of a robot's header *)
  robots : Robot.t list;  (** whose headers are needed *)
  helpers : (Helper.t, unit) Hashtbl.t;
  elementary : (string, unit) Hashtbl.t;  (** functions of the runtime's that are called *)
  makers : (int * int, unit) Hashtbl.t;  (** sum, constructor *)
  projections : (int * int * int, unit) Hashtbl.t;  (** sum, constructor, leaf *)
  arrays : arrays;
  operations : (Array_type.operation * Machine.Ir.ty, string) Hashtbl.t;
      (** functions on arrays, by array type *)
}

and arrays
(** Structs of arrays, named as they are met. *)

val of_program : Machine.Ir.program -> t
val ty : t -> Machine.Ir.ty -> Ir.ty
val helper : t -> Helper.t -> string

val elementary : t -> Core.Primitive.elementary -> string
(** The C function; the square root is <math.h>'s, as exact everywhere. *)

val pow : t -> string
val maker : t -> sum:int -> constructor:int -> string
val projection : t -> sum:int -> constructor:int -> leaf:int -> string
val array_function : t -> Array_type.operation -> Machine.Ir.ty -> string
(** Of an array type. *)

val array_functions : t -> Ir.function_ list
(** All that were asked for. *)

val type_definitions : t -> foreign:bool -> Ir.declaration list
(** Sums and arrays, used before users: those of a robot's header, or the
    program's own. To be called when all code is made. *)

val is_root : t -> int -> bool
val has_state : t -> int -> bool
