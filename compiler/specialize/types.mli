(** Closed types of Core, and what is left of them in Flow.

    A type variable in scope stands for a closed type, by a substitution. Of a closed type the table
    knows once and for all whether Flow can hold its values, and as which leaves. *)

type table

val table : marks:int option -> Core.Ir.program -> table
(** With its data and foreign types. [marks]: for so many a drawing has room; without, drawings and
    texts of labels have no leaves, and all that is drawn comes to nothing. *)

val close : Value.substitution -> Core.Ir.ty -> Core.Ir.ty

(** {1 Layouts} *)

type layout = {
  id : int;  (** equal for equal types *)
  kind : kind;
  first_order : bool;  (** no functions, signal functions or labels inside *)
  leaves : leaf list;  (** in order; none unless first-order *)
}

and kind =
  | Scalar  (** Bool, Int, Float, or a type of the user's C *)
  | Product of part list  (** a tuple, or data with one constructor *)
  | Sum of part list array  (** by constructor *)
  | Array of int * Core.Ir.ty  (** size and element *)
  | Opaque  (** functions, signal functions, labels, programs; a size too *)

and part = { part : string;  (** the field, or the position from 1 *) ty : Core.Ir.ty }
and leaf = { path : string;  (** such as [position.x]; [""] for a scalar *) leaf : Flow.Ir.ty }

val layout : table -> Core.Ir.ty -> layout
(** Of a closed type. *)

val join : string -> string -> string
(** A path below a name: [join "p" "x"] is [p.x]; either may be empty. *)

(** {1 Drawings} Those of the library's module Display: how many marks there are, and an array of
    events, each a mark. *)

val is_drawing : Core.Ir.ty -> bool
val is_text : Core.Ir.ty -> bool

val slot : Core.Ir.ty
(** [Event Mark] *)

val marks : table -> int option
(** As given. *)

val marks_path : string
(** How the path of a leaf ends that is the marks of a drawing. *)

val paths_of_drawing : string list
(** How those of all its leaves end. *)

val text : table -> string -> int
(** The constructor that stands for what a label says. *)

(** {1 For the program as a whole} *)

val shape : table -> Core.Ir.ty -> Flow.Ir.shape
(** Of a closed first-order type. *)

val shape_of_output : table -> Core.Ir.ty -> Flow.Ir.shape
(** The same, without drawings that are parts of it. *)

val shape_of_marks : table -> Flow.Ir.shape
(** The marks of a drawing. *)

val of_the_instant : table -> Flow.Ir.ty -> Flow.Ir.foreign_type option
(** The foreign type, if there is one in it, whose values live for the instant. *)

val sums : table -> Flow.Ir.sum array
(** All that were met. *)

val to_string : Core.Ir.ty -> string
(** As the programmer would write it, without units. *)
