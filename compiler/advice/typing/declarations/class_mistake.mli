(** Messages about classes and instances: a duplicate instance ([E0361]), an invalid instance head
    ([E0362]), missing methods ([E0363]), types of methods ([E0364], [E0365]), and instances of
    built-in classes ([E0366]). *)

open Basis
open Typing

val method_without_variable : Resolve.Ir.method_ -> Ir.variable -> Diagnostic.t
val constrained_variable : Resolve.Ir.constraint_ -> Ir.variable -> Diagnostic.t
val instance_head : Wording.t -> Resolve.Ir.instance -> Type.t -> Diagnostic.t
val second_instance : Wording.t -> Resolve.Ir.instance -> Type.t -> first:Span.t -> Diagnostic.t

val missing_methods :
  Wording.t -> Resolve.Ir.instance -> Type.t -> (Ir.Global.t * Span.t) list -> Diagnostic.t
