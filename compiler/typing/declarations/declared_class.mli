(** Type classes and instances, with the contexts in which their definitions are checked. *)

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
      (** This is not the type of a value: it quantifies over the instance's variables, in the order
          in which they occur in the head, and has the instance's context. *)
  inner : Context.t;  (** the context in which its definitions are checked *)
  definitions : (Ir.Global.t * Resolve.Ir.binding) list;
  place : Span.t;
}
