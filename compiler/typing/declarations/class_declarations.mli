(** Enters type classes and instances into the environment.

    Codes: [E0361] a second instance of a class for the same type constructor · [E0362] an instance
    head that is not a type constructor applied to distinct variables · [E0363] a missing method ·
    [E0364], [E0365] a variable or type that a method's type or a context must not mention · [E0366]
    an instance of a built-in class. *)

open Basis

type method_ = {
  name : Ir.Global.t;
  scheme : Type.scheme;
      (** the class's variable is the first one, and the class itself is the first constraint in the
          context *)
  inner : Context.t;  (** the context in which a default definition is checked *)
  signature : Span.t;
  default : Resolve.Ir.binding option;
}

type class_ = {
  class_ : Ir.Global.t;
  variable : Type.rigid;
  superclasses : (Ir.class_ * Span.t) list;
  methods : method_ list;
}

type instance = {
  of_class : class_;
  head : Type.t;
  scheme : Type.scheme;
      (** This is not the type of a value: it quantifies the variables of the instance, in the order
          in which the head mentions them, and has the instance's context. *)
  inner : Context.t;  (** the context in which its definitions are checked *)
  definitions : (Ir.Global.t * Resolve.Ir.binding) list;
  place : Span.t;
}

val classes : Context.t -> Resolve.Ir.program -> class_ list
(** Enters the classes into the environment, and their methods into the globals. *)

val instances : Context.t -> class_ list -> Resolve.Ir.program -> instance list

val method_of : instance -> method_ -> Type.scheme
(** The type of the method in this instance. The variables of the instance come first. *)
