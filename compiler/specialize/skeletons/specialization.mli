(** A node for each different use of a function or signal function. *)

open Basis

type request = {
  kind : Flow.Ir.kind;
  name : string;  (** the definition's *)
  span : Span.t;  (** the code's *)
  call : Span.t;  (** the place of this use *)
  result : Core.Ir.ty;  (** closed *)
  names : Destructuring.t;
  statics : Skeleton.hole list;
  inputs : Skeleton.hole list;
  key : int;
}

val find :
  Context.t ->
  Context.trail ->
  request ->
  (Context.trail -> Node.t -> Flow.Ir.atom list -> Value.t) ->
  Context.specialization
(** What there is for this key, or else is made as {!call} says. *)

val call :
  Context.t ->
  Context.trail ->
  Node.t ->
  Node.target ->
  request ->
  (Context.trail -> Node.t -> Flow.Ir.atom list -> Value.t) ->
  Value.t
(** The result of a call of the node for this key. If there is none yet the function gives its body,
    from the new node and the signals for statics and inputs. A node without equations is not
    called. May raise {!Context.Postponed}. *)

val finish :
  Context.t ->
  Node.t ->
  name:string ->
  origin:string ->
  span:Span.t ->
  kind:Flow.Ir.kind ->
  statics:Flow.Ir.signal list ->
  inputs:Flow.Ir.signal list ->
  outputs:(string * Flow.Ir.atom) list ->
  transitions:Flow.Ir.transition list ->
  int
(** Adds a node to the program. *)
