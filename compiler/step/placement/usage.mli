(** Counts the uses of values, and decides which values are inlined into the expressions that use
    them and which choices become branches.

    An unnamed value with one use is inlined, unless it is an array. If the expression would have
    more than {!expression_size} operations, its largest operand gets a separate variable. A choice
    becomes an [If] if the values that only its branches need cost more than a select, or if one
    condition chooses many values. A choice that may leave state unchanged always becomes an [If],
    because a chain of selects through memory is slow, while a rarely taken branch is fast. The
    choices that {!Feedback} finds also become [If]s. *)

type t

val update_depth : int
(** Maximum nesting of choices that become branches of one write. *)

val of_fragment : Feedback.t -> Fragment.t -> t

val writes : t -> Fragment.write list
(** The writes to state, in source order, except for those that change nothing. *)

val results : t -> Fragment.write list
val update_atoms : Fragment.update -> Fragment.atom list
val ty : t -> Flow.Ir.signal -> Ir.ty
val leaf : t -> Flow.Ir.signal -> Ir.expr option

val inlined : t -> Flow.Ir.signal -> Fragment.computed option
(** The value of this signal, if it is inlined into the expression that uses the signal. *)

val keep_apart : t -> Flow.Ir.signal -> unit
(** Records that the value needs a separate variable. *)

val choice : t -> Fragment.computed -> (Fragment.atom * Fragment.update * Fragment.update) option
(** The condition and branches of a choice that becomes an [If]. Choices that only these branches
    use become part of the branches, and are not placed separately. *)

val predicted : t -> Fragment.atom -> bool
(** Whether this is the condition of a choice in {!Feedback}. *)

val item_of : t -> Flow.Ir.signal -> (int * Fragment.item) option
(** The item that defines a signal, and its index; [None] for leaves. *)

val item_uses : t -> int -> int
(** The number of uses of all signals that the item defines. *)
