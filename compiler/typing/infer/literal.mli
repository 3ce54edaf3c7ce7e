(** Number literals: their types and exact values (language reference, section 4).

    Codes: [E0313] no [Int] of that value · [E0315] out of any range. *)

open Basis

val number : Context.t -> negative:bool -> at:Span.t -> Resolve.Ir.number -> Type.t * Exact.t
(** The value in base units. Without a point or exponent [n[1]], with one [Float[1]]; with a unit,
    of that unit; zero has every unit; a scaled unit makes it [Float]. *)

val is_only_negative : Resolve.Ir.number -> bool
(** An [Int] in range only with its minus sign, as [-2147483648]. *)
