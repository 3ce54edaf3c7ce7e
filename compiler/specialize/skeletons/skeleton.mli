(** What a node is specialized on: values without their first-order leaves.

    A function or signal function may capture signals and numbers. In the node that is made for it
    each such leaf is a hole, an input of the node, so that one node serves all the numbers. What
    remains, the skeleton, is the node's key.

    A closure that occurs several times in a value is gone through once; one without holes has a
    number of its own for good. So a composition such as [f20 = f19 >>> f19], [f19 = f18 >>> f18]…
    takes linear time. *)

type table
(** All keys so far, as numbers. *)

val table : Types.table -> constants:Core.Constant_numbers.t -> fresh:(unit -> int) -> table
(** [constants]: what is captured in one of these variables is no hole but part of the key, as far
    as it is known. *)

type hole = {
  atom : Flow.Ir.atom;
  local : Core.Ir.Local.t;  (** the variable whose value has it *)
  path : string;  (** where in that value *)
  ty : Flow.Ir.ty;
}

val types : hole list -> Flow.Ir.ty list

(** {1 Taking values apart} *)

type walk

(** What becomes of the numbers inside functions that are captured or passed. *)
type numbers = Holes | In_key  (** they are part of the key *)

val numbers_of : table -> Value.closure -> numbers
(** For the specialization of this closure: [In_key] if there are so many that a long composition,
    of signal functions with numbers in them, would do little but hand them on. *)

val walk : table -> Node.t -> numbers -> walk
(** [Node]: where known constructors of first-order types become leaves. *)

val add : walk -> Core.Ir.Local.t -> Core.Ir.ty -> Value.t -> unit
(** The value of a variable, by its closed type. *)

val add_captured : walk -> Value.closure -> unit
(** What it has captured, and its type arguments. *)

val add_number : walk -> int -> unit
(** Something else that the node depends on. *)

val add_text : walk -> string -> unit

val take_holes : walk -> hole list
(** Those met since the last time, in order. *)

val key : walk -> int
(** Of all that was added, in order. *)

(** {1 Putting them together again} *)

type copy

val copy : table -> numbers -> Flow.Ir.atom list -> copy
(** The atoms that fill the holes, in order, of a walk with these numbers. *)

val value : copy -> Core.Ir.ty -> Value.t -> Value.t
(** The same value with the next atoms in its holes. *)

val captured : copy -> Value.closure -> Value.environment
