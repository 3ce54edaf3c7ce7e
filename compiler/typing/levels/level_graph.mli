(** What makes what a signal: a graph over the local variables of a definition at the top level.

    A node stands for variables that get their values together: those of a binding, a proc's input,
    a function's parameter, or a [case]'s scrutinee. Edges lead from what is mentioned to where.
    Levels are the least that agree with the edges. *)

open Basis

type t
type node

(** Why a node is at least static, whatever it mentions. *)
type origin =
  | Derived  (** it is not *)
  | Bound_signal_function
      (** nor is this: one variable, which must be static, so that a signal is an error at its
          definition and not also where it is used *)
  | Parameter  (** of a function: static, seen from a proc inside it *)
  | Input  (** of a proc *)

val create : unit -> t

val node : t -> depth:int -> origin -> node
(** [depth]: how many procs and functions there are around. *)

val name : t -> Ir.Local.t -> node -> unit
(** The variable belongs to the node. *)

val find : t -> Ir.Local.t -> node option
(** [None] for what has not been met: used before its definition. *)

val depth : node -> int

val mention : Ir.Local.t -> at:Span.t -> node -> within:node -> inside_proc:bool -> unit
(** The variable, of the first node, stands in what defines the second; [inside_proc]: in a proc in
    the scope of the variable, where a signal of the outside may not be and what is not one is at
    most static. *)

val contain : node -> within:node -> unit
(** The definition of the first is a part of the second's. *)

val runs : t -> node -> at:Span.t -> unit
(** An instance stands in the node's definition. *)

val solve : t -> unit
(** To be called once, when all edges are known. Linear. *)

val level : node -> Ir.level
val origin : node -> origin

val explain : Ir.Local.t -> node -> Diagnostic.t -> Diagnostic.t
(** Adds the chain of places that makes a variable a signal. *)
