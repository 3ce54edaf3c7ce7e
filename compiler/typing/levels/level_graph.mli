(** Finds which local variables of a top-level definition are signals.

    In this graph, a node represents variables that get their values together: the variables of a
    binding, of a proc's input, of a function's parameters, or of the patterns of a [case]. An edge
    leads from a variable to each node whose definition mentions it. The levels are the least
    solution of the constraints that the edges express. *)

open Basis

type t
type node

(** The minimum level of a node, independent of its edges. *)
type origin =
  | Derived  (** no minimum *)
  | Bound_signal_function
      (** no minimum; for a single variable that must be static. If the variable turns out to be a
          signal, the error is reported only at its definition, not at its uses *)
  | Parameter  (** a function parameter: static for the procs inside the function *)
  | Input  (** a proc's input: a signal *)

val create : unit -> t

val node : t -> depth:int -> origin -> node
(** [depth]: the number of enclosing procs and functions. *)

val name : t -> Ir.Local.t -> node -> unit
(** Assigns the variable to the node. *)

val find : t -> Ir.Local.t -> node option
(** [None] if the variable has no node yet, because it is used before its definition. *)

val depth : node -> int

val mention : Ir.Local.t -> at:Span.t -> node -> within:node -> inside_proc:bool -> unit
(** Records that the definition of [within] mentions this variable of the first node. [inside_proc]:
    whether a proc inside the variable's scope contains this mention. Such a proc captures signals
    from outside, so the mention raises the level of [within] to at most static. *)

val contain : node -> within:node -> unit
(** Records that the definition of the first node is part of the definition of [within]. *)

val runs : t -> node -> at:Span.t -> unit
(** Records that the node's definition contains an instance. *)

val solve : t -> unit
(** Computes the levels. Call it once, when all edges are known. Linear time. *)

val level : node -> Ir.level
val origin : node -> origin

val reasons : Ir.Local.t -> node -> Level_fact.reason list
(** The chain of places that makes the variable a signal, starting with the variable itself; at most
    eight places. *)
