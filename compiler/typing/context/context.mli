(** The state of type inference, and the questions it postpones.

    Inference computes types first and builds the typed program later. Inferring an expression
    immediately returns its type, together with a function that builds the typed expression. That
    function is called when all types in the top-level group are known. *)

open Basis

type 'a later = unit -> 'a

type entry = {
  scheme : Type.scheme;
  kind : kind;
  at : Span.t option;  (** the place of its signature, if the program has one *)
}

and kind =
  | Defined
  | Recursive
      (** a definition in the group being inferred; it is generalized when the group is finished *)
  | Primitive
  | Method of Ir.Global.t  (** the class that declares it *)

type required = Instance_fact.required = {
  class_ : Ir.class_;
  argument : Type.t;
  at : Span.t;
  by : Instance_fact.user;
  because : (Span.t * Instance_fact.cause) option;
  from : Instance_fact.constraint_ option;
}
(** See {!Instance_fact.required}. *)

type question = {
  attempt : unit -> bool;  (** answers the question if the types known so far allow it *)
  guess : unit -> bool;
      (** answers the question by using the default, if there is one, for types that remain unknown
      *)
  give_up : unit -> unit;
}
(** A question that cannot be answered until a type is known. *)

type t = {
  reader : Annotation.t;
  real : Real.t;
  globals : entry Resolve.Global_table.t;
  bindings : Resolve.Ir.binding Resolve.Global_table.t;  (** all top-level definitions *)
  owners : (int, Surroundings.owned) Hashtbl.t;
      (** the construct that introduces each type variable, by the variable's id *)
  given : (int, Ir.class_ list) Hashtbl.t;
      (** classes in the contexts of the enclosing signatures, by the id of the constrained variable
      *)
  needs : (Instance_fact.constraint_, required) Hashtbl.t;
      (** for each constraint in a definition's context, the use that requires it *)
  scope : Annotation.scope;
  depth : int;  (** number of enclosing signatures *)
  left_operand : (Resolve.Ir.expr * string) option;
      (** the left operand that is currently being inferred, if any, and its operator *)
  around : Surroundings.enclosing list;  (** see {!Surroundings.t} *)
  inputs : (string * Type.t) list;  (** input signals of the enclosing proc *)
  unnamed_input : Span.t option;  (** see {!Surroundings.t} *)
  sources : Source.t;
  doubts : (Span.t, Units.t * Units.t) Hashtbl.t;
      (** for each signature reported as contradicting its definition, the declared unit and the
          actual unit *)
  group : group;
}

and group
(** State of one top-level binding group and its local variables. *)

val start : Annotation.t -> sources:Source.t -> real:Real.t -> t
(** The initial state, outside all groups. *)

val within : t -> ?wanted:Type.t -> Resolve.Ir.expr -> t
(** The state inside this application or record. [wanted]: the type that the expression must have.
*)

val in_group : t -> t
(** The state at the start of a new group. *)

val bind_local : t -> Ir.Local.t -> Type.scheme -> unit

val find_local : t -> Ir.Local.t -> Type.scheme option
(** The scheme of a local variable of this group. *)

val defined_locally : t -> Ir.Local.t -> Resolve.Ir.binding -> unit
(** Records that this binding, which has no signature, defines the local variable. *)

val first_use : t -> Ir.Local.t -> at:Span.t -> Span.t option
(** Records that a local function without a signature is applied at this place. Returns the place of
    its first application, unless this is the first one. *)

val written_unit : t -> Resolve.Ir.unit_ -> Units.t option
(** The unit in base units. [None] if it contains variables. *)

(** {1 New types} *)

val fresh : ?kind:Type.kind -> t -> Type.t
val fresh_number : t -> Type.t

(** {1 Diagnostics} *)

val surroundings : t -> Surroundings.t

val tell : t -> Inference_fact.t -> unit
(** Reports an error. *)

val warn : t -> Inference_fact.t -> unit
(** Reports a warning, also from within {!hold} and {!trial}. *)

val tell_of_instance : t -> Instance_fact.t -> unit
(** Reports an error. *)

val tell_of_declaration : t -> Declaration_fact.t -> unit
(** Reports an error. *)

val hold : t -> (unit -> 'a) -> 'a * Fact.t Facts.held list
(** See {!Facts.hold}. *)

val pass_on : t -> Fact.t Facts.held list -> unit

val replace : t -> Fact.t -> unit
(** Reports a fact in place of a held error. Does not count it, because the held error has already
    been counted. *)

val trial : t -> (unit -> 'a) -> 'a * bool
(** Runs the function only to learn its result and whether it reports errors. Drops the facts, but
    counts the errors, so that enclosing expressions do not explain these errors as well. *)

val tell_too_large : t -> at:Span.t -> Fact.construct -> unit
(** Reports {!Final.Too_large}. *)

val tell_exponent : t -> at:Span.t -> unit
(** Reports a unit whose exponent is out of range. *)

val errors : t -> int
(** The number of errors reported in this group so far. *)

val expect : t -> ?subject:Resolve.Ir.expr -> at:Span.t -> Expected.t -> Type.t -> unit
(** Unifies the type found with the expected type, and reports a mismatch. *)

(** {1 Names} *)

val use :
  t ->
  at:Span.t ->
  name:string ->
  ?said:Span.t ->
  Type.scheme ->
  Type.t * (unit -> Ir.instantiation)
(** Instantiates the scheme, and records the constraints of its context. [said]: the place of the
    signature that states them. *)

val require : t -> required -> unit

val has_no_instance : t -> Ir.class_ -> Type.t -> bool
(** Is the type known to have no instance of the class? *)

val asked_in_vain : t -> wanted:Type.t -> Type.t -> string option
(** The name whose use requires the second type to have a class that the first type lacks. [None] if
    there is no such name, or if the second type is not an unsolved variable. *)

val lacks_class : t -> wanted:Type.t -> Type.t -> bool
(** Does {!asked_in_vain} find a name? *)

val with_variables : t -> by:Surroundings.construct -> Resolve.Ir.scheme -> Type.scheme * t
(** Converts the scheme. Also returns the state for inferring the code of this type, in which the
    scheme's variables are in scope, one level deeper. [by]: the construct that introduces the
    variables. Reports a constraint on something other than a variable ([E0365]) and on a variable
    that the type does not mention ([E0364]). *)

val with_signature : t -> name:string -> Resolve.Ir.scheme -> Type.scheme * t
(** Like {!with_variables}, for the signature of a definition. *)

(** {1 Postponed questions} *)

val ask : t -> question -> unit
(** Tries to answer the question; if that is not possible yet, postpones it until {!settle}. *)

val settle : t -> unit
(** Answers all postponed questions: attempts them repeatedly, guesses when attempts make no
    progress, and finally calls [give_up] for the remaining questions. *)

val forgetting_what_errors_need : t -> (unit -> 'a) -> 'a
(** Runs the function. If it reports errors, drops the constraints it recorded, because they come
    from types that may be wrong. *)

val check_sizes : t -> unit
(** Reports array sizes that nothing determines. Call it after generalization. *)

val requirements : t -> required list
(** The recorded constraints, in source order. *)

(** {1 Expressions} *)

type typed = { ty : Type.t; build : Ir.expr later }

type expressions = {
  infer : t -> Resolve.Ir.expr -> typed;
  check : t -> Resolve.Ir.expr -> Expected.t -> Ir.expr later;  (** reports a mismatch *)
}
(** The inference functions, as a record, to break the recursion between the modules that handle
    different kinds of expressions. *)

exception Too_large of Span.t
(** Raised in place of {!Final.Too_large}, with the place of the expression whose type is too large.
*)

val node : Span.t -> Type.t -> Ir.expr_desc -> Ir.expr
(** A typed expression with its final type. Must be called only after all types have been inferred.
    @raise Too_large *)
