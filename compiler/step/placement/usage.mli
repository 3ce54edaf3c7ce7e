(** Which values are used how often, which ones stand inside the expression of their one user, and
    which choices are worth a branch.

    An unnamed value with one use is inlined (but no array), unless the expression would grow past
    {!expression_size} operations: then its largest operand gets a variable of its own. A choice
    becomes an [If] if what only its branches need costs more than the select (or if many values are
    chosen by one condition); state that a branch keeps is always an [If], because a chain of
    selects through memory is slow, a branch rarely taken is not; so is a choice in {!Feedback}. *)

type t

val expression_size : int

val update_depth : int
(** No write takes apart choices nested deeper. *)

val of_fragment : Feedback.t -> Fragment.t -> t

val writes : t -> Fragment.write list
(** The writes of state, in source order, without those that keep all. *)

val results : t -> Fragment.write list
val update_atoms : Fragment.update -> Fragment.atom list
val ty : t -> Flow.Ir.signal -> Ir.ty
val leaf : t -> Flow.Ir.signal -> Ir.expr option

val inlined : t -> Flow.Ir.signal -> Fragment.computed option
(** The value to build inside its user. *)

val keep_apart : t -> Flow.Ir.signal -> unit
(** From now on the value has a variable of its own. *)

val choice : t -> Fragment.computed -> (Fragment.atom * Fragment.update * Fragment.update) option
(** Condition and branches, if the choice is to be an [If]. Choices that only the branches use
    become part of them, and need no place of their own. *)

val predicted : t -> Fragment.atom -> bool
(** Is this the condition of a choice in {!Feedback}? *)

val item_of : t -> Flow.Ir.signal -> (int * Fragment.item) option
(** Position and item that define a signal; [None] for leaves. *)

val item_uses : t -> int -> int
(** Uses of all that the item defines. *)
