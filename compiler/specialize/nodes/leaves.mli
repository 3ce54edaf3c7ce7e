(** Converts between values and the atoms of a node. *)

open Basis

val atoms : Types.table -> Node.t -> span:Span.t -> Core.Ir.ty -> Value.t -> Flow.Ir.atom list
(** The leaves of a value of a closed first-order type. Known constructors become equations. *)

val known : Types.table -> Core.Ir.ty -> Value.t -> Flow.Ir.atom option list
(** The atom of each leaf, or [None] if obtaining it requires an additional equation. *)

val atom : Types.table -> Node.t -> span:Span.t -> Core.Ir.ty -> Value.t -> Flow.Ir.atom
(** The atom of a value whose type has a single leaf. *)

val value : Types.table -> Core.Ir.ty -> Flow.Ir.atom list -> Value.t
(** The value that consists of these leaves. *)

val component : Value.t -> int -> Value.t
(** A component of a tuple or of data with one constructor. *)

val is_constructor :
  Types.table ->
  Node.t ->
  Node.target ->
  span:Span.t ->
  Core.Ir.ty ->
  Value.t ->
  int ->
  Flow.Ir.atom
(** Does a value of the data type have this constructor? *)

val payload :
  Types.table ->
  Node.t ->
  Node.target ->
  span:Span.t ->
  Core.Ir.ty ->
  Value.t ->
  constructor:int ->
  field:int ->
  Value.t

val select :
  Types.table ->
  Node.t ->
  Node.target ->
  span:Span.t ->
  Core.Ir.ty ->
  Flow.Ir.atom ->
  Value.t ->
  Value.t ->
  Value.t
(** The first value if the condition is true, otherwise the second. *)

val element :
  Types.table -> Node.t -> Node.target -> span:Span.t -> Core.Ir.ty -> Value.t -> int -> Value.t
(** The element of an array at an index, given the array's type. *)

val elements : Types.table -> Node.t -> span:Span.t -> Core.Ir.ty -> Value.t -> Value.t list
(** All elements of an array. *)
