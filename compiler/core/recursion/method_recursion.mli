(** No definition may need itself by way of methods.

    What a method at a type variable is depends on the types at which the definition around it is
    used. So this follows the definitions that use such methods through the types they are used at:
    from the closed definitions, and from each instance, whose methods may be the class's defaults,
    each in terms of the other. *)

open Basis

val check : Diagnostic.sink -> Ir.program -> Uses.t -> unit
(** Emits E0410 for each cycle that a method closes, and E0413 where a method is needed at ever
    larger types. Linear in the uses it follows. *)
