(** What inference carries around, and what it puts off.

    Types come first and the typed program later: inferring an expression gives its type at once and
    a function that builds the typed expression, to be called when everything about the top-level
    group is known. *)

open Basis

type 'a later = unit -> 'a

type entry = {
  scheme : Type.scheme;
  kind : kind;
  at : Span.t option;  (** where the program gives its signature *)
}

and kind =
  | Defined
  | Recursive  (** of the group being inferred: generalized at its end *)
  | Primitive
  | Method of Ir.Global.t  (** of the class *)

type constraint_ = int * Ir.class_
(** Of a quantified variable, by its id. *)

type required = {
  class_ : Ir.class_;
  argument : Type.t;
  at : Span.t;
  by : string;
  because : (Span.t * (Show.words -> string)) option;
  from : constraint_ option;
}
(** A class that something used needs; [by] says what, in backticks; [because] is the other place,
    where that is said, and what is said there; [from]: what in the scheme of the used it stands
    for. *)

type question = {
  attempt : unit -> bool;  (** answers it if it can *)
  guess : unit -> bool;  (** answers it by the rule for what stays unknown, if that can *)
  give_up : unit -> unit;
}
(** A question that waits for a type. *)

type t = {
  reader : Written.t;
  real : Real.t;
  globals : entry Resolve.Global_table.t;
  owners : (int, Signature_mistake.owned) Hashtbl.t;  (** see {!Signature_mistake.owner} *)
  given : (int, Ir.class_ list) Hashtbl.t;
      (** what signatures around promise of their variables, by id *)
  needs : (constraint_, required) Hashtbl.t;
      (** what asked for each constraint in the context of a definition *)
  scope : Written.scope;
  depth : int;  (** signatures around *)
  left_operand : (Resolve.Ir.expr * string) option;
      (** the operand that is being inferred, if it is the left one, and its operator *)
  inputs : (string * Type.t) list;  (** of the proc around: signals *)
  sources : Source.t;
  group : group;
}

and group
(** The top-level binding group being inferred, with the local variables in it. *)

val start : Written.t -> sources:Source.t -> real:Real.t -> t
(** Outside of all groups. *)

val in_group : t -> t
(** The start of a new one. *)

val bind_local : t -> Ir.Local.t -> Type.scheme -> unit

val find_local : t -> Ir.Local.t -> Type.scheme option
(** Of this group. *)

val defined_locally : t -> Ir.Local.t -> Resolve.Ir.binding -> unit
(** By this, without a signature. *)

val first_use : t -> Ir.Local.t -> at:Span.t -> Span.t option
(** Notes that such a function is applied there; where it was before. *)

(** {1 New types} *)

val fresh : ?kind:Type.kind -> t -> Type.t
val fresh_number : t -> Type.t

(** {1 Diagnostics} *)

val words : t -> Show.words
val report : t -> (Show.words -> Diagnostic.t) -> unit

val errors : t -> int
(** Reported in this group so far. *)

val expect : t -> ?subject:Resolve.Ir.expr -> at:Span.t -> Expected.t -> Type.t -> unit
(** The type that was found is the expected one, or that is reported. *)

(** {1 Names} *)

val use :
  t ->
  at:Span.t ->
  name:string ->
  ?said:Span.t ->
  Type.scheme ->
  Type.t * (unit -> Ir.instantiation)
(** A new instance; what its context demands is kept. [said]: the place of its signature. *)

val require : t -> required -> unit

val has_no_instance : t -> Ir.class_ -> Type.t -> bool
(** The type is known well enough to say so. *)

val asked_in_vain : t -> wanted:Type.t -> Type.t -> string option
(** As {!lacks_class}: what asks for it, in backticks. *)

val lacks_class : t -> wanted:Type.t -> Type.t -> bool
(** Something asks for a class of the second type, which is a variable, that the first one has no
    instance of. *)

val with_variables : t -> by:string -> Resolve.Ir.scheme -> Type.scheme * t
(** The scheme and the context of what is below it: its variables in scope, one signature deeper.
    [by]: what names the variables, in messages. Each constraint is of a variable ([E0365]), which
    the type has ([E0364]). *)

val with_signature : t -> name:string -> Resolve.Ir.scheme -> Type.scheme * t
(** Likewise for the definition that it is the signature of. *)

(** {1 What is put off} *)

val ask : t -> question -> unit
(** Attempts at once, else at {!settle}. *)

val settle : t -> unit
(** Until nothing waits: attempts all, and where that gets no further, guesses; at last gives up. *)

val forgetting_what_errors_need : t -> (unit -> 'a) -> 'a
(** Runs a function; if it reports errors, no class that it asked for is demanded: its types are not
    to be trusted. *)

val check_sizes : t -> unit
(** Once the group is generalized: reports a size that nothing decides. *)

val requirements : t -> required list
(** In the order of the source. *)

(** {1 Expressions} *)

type typed = { ty : Type.t; build : Ir.expr later }

type expressions = {
  infer : t -> Resolve.Ir.expr -> typed;
  check : t -> Resolve.Ir.expr -> Expected.t -> Ir.expr later;  (** Reports what does not fit. *)
}
(** Inference of expressions, as given to the files that treat one kind of them. *)

exception Too_large of Span.t
(** {!Final.Too_large}, of this expression's type and of none in it. *)

val node : Span.t -> Type.t -> Ir.expr_desc -> Ir.expr
(** Of its type as inference leaves it: to be built when all is inferred.
    @raise Too_large *)
