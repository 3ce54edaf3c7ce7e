(** Messages about the types of imported C functions: types without a counterpart in C ([E0380]),
    and one function with two types ([E0381]). *)

open Basis
open Typing

val refused : Resolve.Ir.primitive -> Declaration_fact.refusal -> Diagnostic.t

val imported_twice :
  string -> this:Declaration_fact.imported -> first:Declaration_fact.imported -> Diagnostic.t
(** The message about two imports of the same C function with different types. *)
