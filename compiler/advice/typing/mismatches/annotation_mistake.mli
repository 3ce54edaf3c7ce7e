(** Messages about types and units in the source. Codes: [E0321] a scaled unit in a type · [E0322] a
    non-integer power of a scaled unit · [E0330] a size in place of a type, or the reverse · [E0333]
    a size out of range. *)

open Basis
open Typing

val scaled_power : at:Span.t -> Ir.Global.t -> Rational.t -> Diagnostic.t

val scaled_unit : Environment.t -> Span.t list -> Units.t -> Diagnostic.t
(** The list contains every place where the scaled unit occurs. *)

val array_size : at:Span.t -> int -> largest:int -> Diagnostic.t
val wrong_kind : Source.t -> Environment.t -> at:Span.t -> Type.kind -> Type.t -> Diagnostic.t
