(** Type classes and instances, read into the environment.

    Codes: [E0361] a second instance for a class and type constructor · [E0362] a head that is no
    type constructor applied to distinct variables · [E0363] a method that is not given · [E0364],
    [E0365] what a method's type or a context may speak of · [E0366] an instance of a built-in
    class. *)

open Basis

type method_ = {
  name : Ir.Global.t;
  scheme : Type.scheme;  (** the class's variable comes first, its own class first in the context *)
  inner : Context.t;  (** where a default is checked *)
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
  scheme : Type.scheme;  (** of no value: its variables, in the order of the head, and context *)
  inner : Context.t;  (** where its definitions are checked *)
  definitions : (Ir.Global.t * Resolve.Ir.binding) list;
  place : Span.t;
}

val classes : Context.t -> Resolve.Ir.program -> class_ list
(** Enters the methods among the globals. *)

val instances : Context.t -> class_ list -> Resolve.Ir.program -> instance list

val method_of : instance -> method_ -> Type.scheme
(** The method's type in the instance: the instance's variables come first. *)
