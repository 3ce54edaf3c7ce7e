(** Messages about the user's C: names that the generated C also has ([E0431]), and values that
    cannot be kept ([E0430]). *)

open Basis

val name : Specialize.Fact.foreign_name -> Diagnostic.t

val of_the_instant : at:Span.t -> Flow.Ir.foreign_type -> Diagnostic.t
(** A value of this type would have to be kept from one instant to the next. *)
