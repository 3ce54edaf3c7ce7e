(** Messages about the user's C code: names that clash with the generated code ([E0431]), and values
    that cannot be kept ([E0430]). *)

open Basis

val name : Specialize.Fact.foreign_name -> Diagnostic.t

val of_the_instant : at:Span.t -> Flow.Ir.foreign_type -> Diagnostic.t
(** Reports a value of this type that would have to be kept from one instant to the next. *)
