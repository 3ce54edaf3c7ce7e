(** What a node is specialized on: values without their first-order leaves.

    A function or signal function may capture signals and numbers. In the node
    that is made for it each such leaf is a hole, an input of the node, so
    that one node serves all the numbers. What remains, the skeleton, is the
    node's key.

    A closure that occurs several times in a value is gone through once; one
    without holes has a number of its own for good. So a composition such as
    [f20 = f19 >>> f19], [f19 = f18 >>> f18]… takes linear time. *)

type table
(** All keys so far, as numbers. *)

val table : Types.table -> fresh:(unit -> int) -> table

exception Needs_itself of Core.Ir.Local.t

val forced : Value.entry -> Value.t
(** The value of a variable. Raises {!Needs_itself} if its evaluation comes
    back to it. *)

val code_id : Value.code -> int
(** See {!Free}. *)

type hole = {
  atom : Flow.Ir.atom;
  local : Core.Ir.Local.t;  (** the variable whose value has it *)
  path : string;  (** where in that value *)
  ty : Flow.Ir.ty;
}

val type_of_atom : Flow.Ir.atom -> Flow.Ir.ty

(** {1 Taking values apart} *)

type walk

val walk : table -> Node.t -> walk
(** [Node]: where known constructors of first-order types become leaves. *)

val add : walk -> Core.Ir.Local.t -> Core.Ir.ty -> Value.t -> unit
(** The value of a variable, by its closed type. *)

val add_captured : walk -> Value.closure -> unit
(** What it has captured, and its type arguments. *)

val add_number : walk -> int -> unit
(** Something else that the node depends on. *)

val take_holes : walk -> hole list
(** Those met since the last time, in order. *)

val key : walk -> int
(** Of all that was added, in order. *)

(** {1 Putting them together again} *)

type copy

val copy : table -> Flow.Ir.atom list -> copy
(** The atoms that fill the holes, in order. *)

val value : copy -> Core.Ir.ty -> Value.t -> Value.t
(** The same value with the next atoms in its holes. *)

val captured : copy -> Value.closure -> Value.environment
