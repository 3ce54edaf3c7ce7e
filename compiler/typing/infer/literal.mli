(** Number literals: their types and exact values (language reference, section 4).

    Codes: [E0313] the value is not an [Int] · [E0315] the value exceeds the range of every number
    type. *)

open Basis

val number : Context.t -> negative:bool -> at:Span.t -> Resolve.Ir.number -> Type.t * Exact.t
(** The type, and the value in base units. A literal with neither a point nor an exponent has type
    [n[1]]; any other has type [Float[1]]. A unit suffix replaces the unit [1]. Zero can have any
    unit. A scaled unit makes the literal a [Float]. *)

val is_only_negative : Resolve.Ir.number -> bool
(** Is this an [Int] that is in range only with its minus sign, such as [-2147483648]? *)
