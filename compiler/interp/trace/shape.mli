(** The structure of an input or output in a trace. *)

type t =
  | Bool
  | Int
  | Float of Basis.Real.t
  | Tuple of t list
  | Array of int * t
  | Text  (** the text of a label *)
  | Drawing  (** a drawing, which has no column; {!drawings} returns its marks *)
  | Image  (** an image, written as a reference to its file *)
  | Data of { is_event : bool; constructors : constructor list }
  | Console of (string * t * Value.t) list
      (** the label, shape and initial value of each control *)

and constructor = {
  name : string;
  fields : (string * t) list;  (** the names are [""] if the fields are positional *)
}

val is_record : constructor -> bool
(** Does the constructor have named fields? *)

val of_type : Core.Ir.program -> Core.Ir.ty -> t
(** Shape of a closed type that contains no functions and no labels. *)

(** {1 Columns}

    A tuple, record, array or console has the columns of its parts. A drawing has no column. Any
    other value has one. *)

type column = {
  name : string;  (** its path, such as [in.position.x] *)
  shape : t;
  at_rest : Value.t option;  (** default value of a console column, which may be missing *)
}

val columns : string -> t -> column list
(** The columns of a shape. The first argument is the first word of their paths. *)

val cells : t -> Value.t -> Value.t list
(** The parts of a completely evaluated value, one for each column. *)

val assemble : t -> Value.t list -> Value.t
(** The inverse of {!cells}: builds a value from its cells. *)

val drawings : t -> Value.t -> Value.thunk list list
(** The marks of each drawing in the value, bottommost first. Skips drawings that are part of a
    value in a single cell, such as an event. *)

val count_drawings : t -> int
(** The number of drawings that {!drawings} returns. *)
