(** Specialization keys: values without their first-order leaves.

    A function or signal function may capture signals and numbers. In the node created for it, each
    such leaf is a hole, that is, an input of the node, so that one node can be used for all
    numbers. The rest of the value, its skeleton, is the key of the node.

    A closure that occurs several times in a value is visited once, and a closure without holes
    keeps its key permanently. Therefore a chain of compositions such as [f20 = f19 >>> f19],
    [f19 = f18 >>> f18]… takes linear time. *)

type table
(** All keys so far. A key is a number. *)

val table : Types.table -> constants:Core.Constant_numbers.t -> fresh:(unit -> int) -> table
(** [constants]: known values in these variables are part of the key rather than holes. *)

type hole = {
  atom : Flow.Ir.atom;
  local : Core.Ir.Local.t;  (** the variable whose value contains the hole *)
  path : string;  (** the hole's path in that value *)
  ty : Flow.Ir.ty;
}

val types : hole list -> Flow.Ir.ty list

(** {1 Traversing values} *)

type walk

(** How to treat the numbers inside functions that are captured or passed. *)
type numbers = Holes | In_key  (** the numbers are part of the key *)

val numbers_of : table -> Value.closure -> numbers
(** The treatment to use when specializing this closure. It is [In_key] for a closure with many
    numbers inside, such as a long composition. With [Holes], the nodes of such a closure would do
    little except pass the numbers on. *)

val walk : table -> Node.t -> numbers -> walk
(** [Node]: the node that receives the equations for known constructors of first-order types. *)

val add : walk -> Core.Ir.Local.t -> Core.Ir.ty -> Value.t -> unit
(** Adds the value of a variable, given its closed type. *)

val add_captured : walk -> Value.closure -> unit
(** Adds the captured variables and type arguments of a closure. *)

val add_number : walk -> int -> unit
(** Adds a number to the key, for anything else that the node depends on. *)

val add_text : walk -> string -> unit

val take_holes : walk -> hole list
(** The holes that were found since the last call, in order. *)

val key : walk -> int
(** The key of everything that was added, in order. *)

(** {1 Rebuilding values} *)

type copy

val copy : table -> numbers -> Flow.Ir.atom list -> copy
(** Starts a copy that fills the holes of a walk with these atoms, in order. [numbers] must be the
    same as for the walk. *)

val value : copy -> Core.Ir.ty -> Value.t -> Value.t
(** A copy of the value with the next atoms in its holes. *)

val captured : copy -> Value.closure -> Value.environment
