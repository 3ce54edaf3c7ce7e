(** Warnings about angles that wrap from pi to -pi ([W0315]). *)

open Basis
open Typing

val difference : Source.t -> Resolve.Ir.program -> Ir.expr -> Ir.expr -> Ir.expr -> Diagnostic.t
(** A difference, with its operands. *)

val wrapped :
  Resolve.Ir.program ->
  name:string ->
  head:Ir.expr ->
  angle:Ir.expr ->
  scaled:bool ->
  instead:string ->
  module_:string ->
  same_arguments:bool ->
  Warning_fact.unwrap ->
  Diagnostic.t
(** See {!Warning_fact.Wrapped_angle}; [name] is the name of the function. *)
