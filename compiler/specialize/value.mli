(** Values of Core expressions during specialization.

    A value of a first-order type (numbers, and data and tuples of them) consists of atoms of the
    node under construction. Values that Flow cannot represent, that is, functions, signal functions
    and data that contains them, exist only in this form and disappear when specialization ends. *)

type t =
  | Atom of Flow.Ir.atom  (** one leaf: a number, a Bool or a whole sum *)
  | Text of string  (** the text of a label, which has no run-time form *)
  | Product of t array  (** a tuple, or data with one constructor *)
  | Constructed of { constructor : int; arguments : t list }  (** a sum with a known constructor *)
  | Array of Flow.Ir.atom list
      (** an array of a first-order type: one Flow array per leaf of an element *)
  | Elements of t list  (** an array whose elements are known individually *)
  | Function of closure  (** its code is a [Lambda] *)
  | Signal_function of closure  (** its code is a [Proc] *)
  | Primitive of {
      primitive : Core.Primitive.t;
      types : Core.Ir.ty list;  (** closed types *)
      arguments : argument list;  (** last one first *)
      owner : string;  (** the definition that contains this application *)
      at : Basis.Span.t;
          (** the place of this application; for a task, a place in the program rather than in the
              library *)
    }  (** a partial application, or a signal function *)
  | Choice of { condition : Flow.Ir.atom; then_ : t; else_ : t }
      (** an [if] with a condition that is known only at run time, between values that Flow cannot
          represent *)
  | Program of t  (** a [Program i o], represented by its signal function *)
  | Unspecified
      (** an arbitrary value, for the payload of another constructor or for an expression that was
          reported as an error *)

and argument = { value : t; ty : Core.Ir.ty  (** closed *) }

and closure = {
  identity : int;
      (** identifies this evaluation of the code: shared closures have equal identities *)
  name : string;  (** the definition or local function that contains the code *)
  code : code;
  captured : environment;  (** the values of exactly the free variables of the code *)
  types : substitution;
  span : Basis.Span.t;
}

and code = Lambda of Core.Ir.binder * Core.Ir.expr | Proc of Core.Ir.proc
and environment = entry Variables.t

and substitution = Core.Ir.ty Variables.t
(** The closed types of the type variables in scope. *)

and entry = {
  local : Core.Ir.Local.t;
  local_ty : Core.Ir.ty;  (** closed *)
  mutable contents : contents;
}

and contents =
  | Known of t
  | Suspended of (unit -> t)
      (** an equation in a proc, if Flow cannot represent its value. It is evaluated on first use,
          so that the order of equations is irrelevant *)
  | Being_evaluated
