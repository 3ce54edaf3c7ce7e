(** Reports definitions that depend on themselves through methods.

    The definition of a method at a type variable depends on the types at which the enclosing
    definition is used. This check therefore follows the definitions that use such methods, together
    with their type arguments. It starts from the closed definitions and from each instance, because
    an instance's methods may be class defaults that are defined in terms of each other. *)

val facts : Ir.program -> Uses.t -> Fact.t list
(** Reports each cycle that goes through a method, and each method that is required at ever larger
    types. Linear in the number of uses followed. *)
