(** Creates a node for each distinct specialization of a function or signal function. *)

open Basis

type request = {
  kind : Flow.Ir.kind;
  name : string;  (** the name of the definition *)
  span : Span.t;  (** the place of the code *)
  call : Span.t;  (** the place of this call *)
  result : Core.Ir.ty;  (** closed *)
  names : Destructuring.t;
  statics : Specialization_key.hole list;
  inputs : Specialization_key.hole list;
  key : int;
}

val find :
  Context.t ->
  Context.trail ->
  request ->
  (Context.trail -> Node.t -> Flow.Ir.atom list -> Value.t) ->
  Context.specialization
(** Returns the specialization with this key. If it does not exist yet, creates it as described at
    {!call}. *)

val call :
  Context.t ->
  Context.trail ->
  Node.t ->
  Node.target ->
  request ->
  (Context.trail -> Node.t -> Flow.Ir.atom list -> Value.t) ->
  Value.t
(** Calls the node with this key and returns the result. If there is no such node yet, creates one;
    the function builds its body, given the new node and the signals for the statics and inputs. A
    node without equations is not called; the caller computes its outputs. May raise
    {!Context.Postponed}. *)

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
(** Adds the finished node to the program. *)
