(** Enters type classes and instances into the environment.

    Codes: [E0361] a second instance of a class for the same type constructor · [E0362] an instance
    head that is not a type constructor applied to distinct variables · [E0363] a missing method ·
    [E0364], [E0365] a variable or type that a method's type or a context must not mention · [E0366]
    an instance of a built-in class. *)

open Declared_class

val classes : Context.t -> Resolve.Ir.program -> class_ list
(** Enters the classes into the environment, and their methods into the globals. *)

val instances : Context.t -> class_ list -> Resolve.Ir.program -> instance list

val method_of : instance -> method_ -> Type.scheme
(** The type of the method in this instance. The variables of the instance come first. *)
