(** Warnings about constants: NaN ([W0307]), Ints that wrap around ([W0308]), and constants that a
    function or a record does not accept ([W0309], [W0316]). *)

open Basis
open Typing

val not_a_number : Ir.expr -> Diagnostic.t

val wraps_around : Ir.expr -> int -> Diagnostic.t
(** The constant is an Int with this value. *)

val unmet : of_:string -> Ir.expr -> Warning_fact.unmet -> Diagnostic.t
val swapped_limits : of_:string -> low:Ir.expr -> high:Ir.expr -> Diagnostic.t
val limits_cross : limit:Ir.expr -> other:Ir.expr -> Diagnostic.t
val limited_constant : low:Ir.expr -> high:Ir.expr -> limited:Ir.expr -> Diagnostic.t
