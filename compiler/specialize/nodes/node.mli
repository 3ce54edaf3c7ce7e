(** A Flow node under construction. *)

open Basis

type t

val create : fresh:(unit -> int) -> t
(** [fresh] returns numbers that are unique within the program. *)

(** The destination of an expression's result. *)
type target =
  | Unnamed
  | Named of string  (** the programmer's name for the value *)
  | Defines of Flow.Ir.signal list
      (** these signals, one for each leaf. Evaluation either defines them as the result or leaves
          them undefined; see {!settle} *)

val parts : target -> Types.table -> Types.part list -> target list
(** The targets for the components of a tuple or record. *)

val leaves : target -> Types.leaf list -> target list
val signal : t -> name:string -> span:Span.t -> Flow.Ir.ty -> Flow.Ir.signal

val promise : t -> name:string -> span:Span.t -> Types.leaf list -> Flow.Ir.signal list
(** Creates signals that can be read before their equations exist. *)

val settle : t -> span:Span.t -> Flow.Ir.signal list -> Flow.Ir.atom list -> unit
(** Completes promised signals: if evaluation has left one of them undefined, defines it as a copy
    of its value. *)

val define : t -> target -> span:Span.t -> Flow.Ir.ty -> Flow.Ir.rhs -> Flow.Ir.atom
(** Adds an equation for a target with a single leaf. *)

val call :
  t ->
  target list ->
  ?loop:Flow.Ir.loop ->
  callee:string ->
  node:int ->
  span:Span.t ->
  statics:Flow.Ir.atom list ->
  inputs:Flow.Ir.atom list ->
  Flow.Ir.ty list ->
  Flow.Ir.atom list
(** Adds an instance, given a target and a type for each output, and returns the outputs. *)

val set_machine : t -> Flow.Ir.machine -> unit
val machine : t -> Flow.Ir.machine option

val size : t -> int
(** The number of equations and instances; a machine counts as one. *)

val equations : t -> Flow.Ir.equation list
val instances : t -> Flow.Ir.instance list

(** {1 Cached values that depend on signals of this node} *)

val global : t -> int -> Value.t option
(** The cached value of the definition with this key. *)

val add_global : t -> int -> Value.t -> unit

val join : t -> int -> Value.t option
(** The cached result of a local function with the parameter [()], given the identity of its
    closure. Such a function is a join point, where branches of a [case] meet. *)

val add_join : t -> int -> Value.t -> unit
