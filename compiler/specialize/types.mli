(** Closed types of Core, and what is left of them in Flow.

    A type variable in scope stands for a closed type, by a substitution. Of a
    closed type the table knows once and for all whether Flow can hold its
    values, and as which leaves. *)

type table

val table : Core.Ir.program -> table
(** With its data and foreign types. *)

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

(** {1 For the program as a whole} *)

val shape : table -> Core.Ir.ty -> Flow.Ir.shape
(** Of a closed first-order type. *)

val of_the_instant : table -> Flow.Ir.ty -> string option
(** The foreign type, if there is one in it, whose values live for the instant. *)

val sums : table -> Flow.Ir.sum array
(** All that were met. *)

val to_string : Core.Ir.ty -> string
(** As the programmer would write it, without units. *)
