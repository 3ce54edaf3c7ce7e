(** A Flow node under construction. *)

open Basis

type t

val create : fresh:(unit -> int) -> t
(** [fresh] gives numbers that are unique in the program. *)

(** Where the result of an expression goes. *)
type target =
  | Unnamed
  | Named of string  (** the programmer's name for the value *)
  | Defines of Flow.Ir.signal list
      (** these signals, one for each leaf; an expression's evaluation uses them for its result or
          not at all, see {!settle} *)

val parts : target -> Types.table -> Types.part list -> target list
(** Of a tuple's or record's target, those of its parts. *)

val leaves : target -> Types.leaf list -> target list
val signal : t -> name:string -> span:Span.t -> Flow.Ir.ty -> Flow.Ir.signal

val promise : t -> name:string -> span:Span.t -> Types.leaf list -> Flow.Ir.signal list
(** Signals that can be read before their equations are there. *)

val settle : t -> span:Span.t -> Flow.Ir.signal list -> Flow.Ir.atom list -> unit
(** Keeps a promise: those signals that evaluation has not defined by itself become copies of the
    values. *)

val define : t -> target -> span:Span.t -> Flow.Ir.ty -> Flow.Ir.rhs -> Flow.Ir.atom
(** One more equation; the target is one leaf's. *)

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
(** One more instance; a target and a type for each output, which it returns. *)

val set_machine : t -> Flow.Ir.machine -> unit
val machine : t -> Flow.Ir.machine option

val size : t -> int
(** Of equations and instances; a machine counts as one. *)

val equations : t -> Flow.Ir.equation list
val instances : t -> Flow.Ir.instance list

(** {1 Values that are made of signals of this node} *)

val global : t -> int -> Value.t option
(** Of a definition, by a key. *)

val add_global : t -> int -> Value.t -> unit

val join : t -> int -> Value.t option
(** The result of a local function of [()], where the branches of a [case] meet again, by the
    closure's identity. *)

val add_join : t -> int -> Value.t -> unit
