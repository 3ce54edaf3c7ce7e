(** What the elements of a node are, but for the signals that they read: what a
    partition by congruence starts from ({!Common_subexpressions}). *)

type t =
  | Equation of Ir.ty * Ir.rhs
  | Instance of Ir.instance
  | Output of int  (** of an instance, that number *)

val operands : t -> Ir.atom list
(** What it reads, in order; of an output nothing. *)

val hash : t -> int
(** Equal for equal labels. *)

module Table : Hashtbl.S with type key = t
(** Two labels are equal if they do the same with signals that may be others.
    Literals count: floats by their bits. *)
