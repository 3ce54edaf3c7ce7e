(** The values of an input or output, as a trace has to write and read them. *)

type t =
  | Bool
  | Int
  | Float of Basis.Real.t
  | Tuple of t list
  | Array of int * t
  | Text  (** what a label says *)
  | Drawing  (** of which nothing is seen but by {!drawings} *)
  | Image  (** the name of a file *)
  | Data of { is_event : bool; constructors : constructor list }
  | Console of (string * t * Value.t) list
      (** what is on it, by its label, with what that is while nobody touches it *)

and constructor = {
  name : string;
  fields : (string * t) list;  (** the names are [""] if positional *)
}

val is_record : constructor -> bool
(** Its fields have names; it has some. *)

val of_type : Core.Ir.program -> Core.Ir.ty -> t
(** Of a closed type without functions and labels. *)

(** {1 Columns} A tuple, record or array has the columns of its parts, everything
    else is a column of its own. *)

type column = {
  name : string;  (** its path, as [in.position.x] *)
  shape : t;
  at_rest : Value.t option;  (** what stands for a column of the console that is not there *)
}

val columns : string -> t -> column list
(** From the path's first word. *)

val cells : t -> Value.t -> Value.t list
(** The parts of a wholly evaluated value that are the columns' cells. *)

val assemble : t -> Value.t list -> Value.t
(** The value with these cells. *)

val drawings : t -> Value.t -> Value.thunk list list
(** The marks of each drawing in it, the first one at the bottom; not those in a cell. *)

val count_drawings : t -> int
(** How many these are. *)
