(** Closed types of Core, and their representation in Flow.

    Type variables in scope are replaced by closed types, through a substitution. For each closed
    type, the table caches whether Flow can represent its values, and which leaves they have. *)

type table

val table : marks:int option -> Core.Ir.program -> table
(** The table for a program's data types and foreign types. [marks]: the maximum number of marks in
    a drawing. If it is [None], drawings and label texts have no leaves, and drawing has no effect.
*)

val close : Value.substitution -> Core.Ir.ty -> Core.Ir.ty

(** {1 Layouts} *)

type layout = {
  id : int;  (** equal types have equal ids *)
  kind : kind;
  first_order : bool;  (** whether values contain no functions, signal functions or labels *)
  leaves : leaf list;  (** the leaves in order; empty unless the type is first-order *)
  nesting : int;  (** the number of nested levels of tuples, data and arrays *)
}

and kind =
  | Scalar  (** Bool, Int, Float, or a foreign type *)
  | Product of part list  (** a tuple, or data with one constructor *)
  | Sum of part list array  (** the fields of each constructor *)
  | Array of int * Core.Ir.ty  (** size and element type *)
  | Opaque  (** functions, signal functions, labels, programs and sizes *)

and part = { part : string;  (** the field name, or the position, starting at 1 *) ty : Core.Ir.ty }

and leaf = {
  path : string list;
      (** for example [position; x], outermost first; empty for a scalar. The paths in nested
          records share their tails *)
  leaf : Flow.Ir.ty;
}

exception Too_large of Core.Ir.ty
(** A value of this type would have more than {!most_leaves} signals. *)

val most_leaves : int

exception Too_deep of Core.Ir.ty
(** The {!type-layout.nesting} of this type would exceed {!deepest}. *)

val deepest : int

val layout : table -> Core.Ir.ty -> layout
(** The layout of a closed type. *)

val path_name : leaf -> string
(** The path as one word: [position.x]. It is [""] for a scalar. *)

val join : string -> string -> string
(** Appends a path to a name: [join "p" "x"] is [p.x]. Either may be empty. *)

(** {1 Drawings}

    A drawing, from the library's module Display, consists of the number of marks and an array of
    events, each with one mark as its value. *)

val is_drawing : Core.Ir.ty -> bool
val is_text : Core.Ir.ty -> bool

val slot : Core.Ir.ty
(** [Event Mark] *)

val marks : table -> int option
(** The maximum number of marks, as passed to {!table}. *)

val marks_path : string
(** The path suffix of a leaf that contains a drawing's marks. *)

val paths_of_drawing : string list
(** The path suffixes of a drawing's leaves. *)

val text : table -> string -> int
(** The constructor that represents a label text. *)

(** {1 Information about the whole program} *)

val shape : table -> Core.Ir.ty -> Flow.Ir.shape
(** The shape of a closed first-order type. *)

val shape_of_output : table -> Core.Ir.ty -> Flow.Ir.shape
(** The shape of an output, without the drawings in it. *)

val shape_of_marks : table -> Flow.Ir.shape
(** The shape of a drawing's marks. *)

val of_the_instant : table -> Flow.Ir.ty -> Flow.Ir.foreign_type option
(** A foreign type inside this type whose values are valid for only one instant, if there is one. *)

val sums : table -> Flow.Ir.sum array
(** All sums encountered so far. *)

val to_string : Core.Ir.ty -> string
(** The type in source syntax, without units. *)
