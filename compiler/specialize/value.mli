(** What an expression of Core is while everything static is being run.

    A value of a first-order type (numbers, and data and tuples of them) is made of atoms of the
    node under construction. What Flow cannot hold, that is functions, signal functions and data
    that contains some, exists only as these values and is gone when specialization ends. *)

type t =
  | Atom of Flow.Ir.atom  (** one leaf: a number, a Bool or a whole sum *)
  | Text of string  (** labels have no run-time form *)
  | Product of t list  (** a tuple, or data with one constructor *)
  | Constructed of { constructor : int; arguments : t list }
      (** a sum whose constructor is known *)
  | Array of Flow.Ir.atom list  (** of a first-order type: an array for each leaf of an element *)
  | Elements of t list  (** an array whose elements are known one by one *)
  | Function of closure  (** its code is a [Lambda] *)
  | Signal_function of closure  (** its code is a [Proc] *)
  | Primitive of {
      primitive : Core.Primitive.t;
      types : Core.Ir.ty list;  (** closed *)
      arguments : argument list;  (** the last one first *)
      owner : string;  (** the definition that says so *)
      at : Basis.Span.t;  (** where; of a task, in the program rather than in the library *)
    }  (** applied to fewer arguments than it takes, or a signal function *)
  | Choice of { condition : Flow.Ir.atom; then_ : t; else_ : t }
      (** an [if] whose condition only the running program knows, of values that Flow cannot select
          from *)
  | Program of t  (** [Program i o]: its signal function *)
  | Unspecified
      (** what a payload is when another constructor was there, and the result of what was reported
          as an error; any value would do *)

and argument = { value : t; ty : Core.Ir.ty  (** closed *) }

and closure = {
  identity : int;  (** of this one evaluation of the code: shared closures are equal *)
  name : string;  (** the definition or local function it belongs to *)
  code : code;
  captured : environment;  (** exactly the free variables of the code *)
  types : substitution;
  span : Basis.Span.t;
}

and code = Lambda of Core.Ir.binder * Core.Ir.expr | Proc of Core.Ir.proc
and environment = entry Variables.t

and substitution = Core.Ir.ty Variables.t
(** Closed types for the type variables in scope. *)

and entry = {
  local : Core.Ir.Local.t;
  local_ty : Core.Ir.ty;  (** closed *)
  mutable contents : contents;
}

and contents =
  | Known of t
  | Suspended of (unit -> t)
      (** an equation of a proc that Flow cannot hold: evaluated where first needed, so that the
          order of equations has no meaning *)
  | Being_evaluated
