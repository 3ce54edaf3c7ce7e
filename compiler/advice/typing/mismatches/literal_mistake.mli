(** Messages about numbers and array literals. Codes: [E0313] an `Int` out of range · [E0315]
    another number out of range · [E0333] the length of an array. *)

open Basis

val long_array : at:Span.t -> length:int -> longest:int -> Diagnostic.t
val empty_array : Span.t -> Diagnostic.t

val int_out_of_range : at:Span.t -> Resolve.Ir.number -> same_bits:int32 option -> Diagnostic.t
(** [same_bits]: the [Int] with the same 32 bits as the literal, if there is one. *)

val out_of_range : at:Span.t -> Resolve.Ir.number -> Real.t -> Diagnostic.t
