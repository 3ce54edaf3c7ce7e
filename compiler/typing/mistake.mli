(** What is said about types that do not fit, in the words of the program.

    Codes: [E0301] different types · [E0302] not a function, or too many
    arguments · [E0303] a signal function where its signal's value is wanted ·
    [E0304] a function where a signal function is wanted, or the reverse ·
    [E0305] an infinite type · [E0306] a signature more general than its
    definition · [W0302] its variable is named like a type · [E0312] Int and Float · [E0320] units · [E0323] exponents ·
    [E0370] no task in a [do] · [E0371] a task where a signal function is
    wanted, or the reverse. *)

open Basis

(** Why a type is expected at a place. *)
type reason =
  | Unknown
  | Signature of { name : string; at : Span.t }
  | Annotation of Span.t
  | Parameter of {
      callee : string option;
      at : Span.t;
      position : int;
      decided_by : (Span.t * Type.t) option;
          (** an earlier argument, where the parameter's type has that argument's type in it *)
      before : string option;  (** the operator behind the argument, if it is the last one *)
    }
  | Operand of { operator : string; other : Resolve.Ir.expr; other_type : Type.t }
      (** beside the other operand *)
  | Branch of Span.t  (** an earlier branch *)
  | Condition
  | Element of Span.t  (** of an array: the first one *)
  | Value of Span.t  (** a pattern's: the value that is matched *)
  | Pattern of Span.t  (** a value's: the pattern that takes it apart *)
  | Statement of Span.t option
      (** of a [do], and what says of its tasks what goes in and comes out *)
  | Last_statement of reason  (** of a [do] that is expected for this reason *)
  | Uses of { name : string; at : Span.t }  (** of what is being defined *)
  | Field of { name : string; at : Span.t }
  | Output of reason  (** of the signal function that is expected for this reason *)

type expected = { ty : Type.t; because : reason }

val expecting : reason -> Type.t -> expected

type owned = { by : string;  (** [the signature of `f`] *) place : Span.t }

type owner = Ir.variable -> owned option
(** Where a variable was named. *)

val mismatch :
  Show.words ->
  owner ->
  subject:Resolve.Ir.expr option ->
  at:Span.t ->
  expected:expected ->
  found:Type.t ->
  Unify.clash ->
  Diagnostic.t
(** [subject] is the expression at fault, if it is one. The clash is that of
    [Unify.types expected found]. *)

val described : Show.words -> Type.t -> string
(** A type in a sentence: quoted, or [a number]. *)

val explain : Show.words -> reason -> Type.t -> Diagnostic.t -> Diagnostic.t
(** Labels the other place: where the expected type comes from. *)

val name_of : Resolve.Ir.expr -> string option
(** Of a plain name. *)

val not_a_function :
  Show.words ->
  head:Resolve.Ir.expr ->
  position:int ->
  at:Span.t ->
  Type.t ->
  Diagnostic.t
(** What is left of the head's type cannot take the argument of that number. *)

val negative_argument :
  Show.words -> minus:Span.t -> Resolve.Ir.expr -> Type.t -> Diagnostic.t
(** [f -1], where [f] is a function of that type. *)

val not_a_signal_function :
  Show.words -> head:Resolve.Ir.expr -> Type.t -> Diagnostic.t
(** The head of [sf -< e]. *)

val variable_like_a_type : at:Span.t -> Ir.variable -> Diagnostic.t option
(** A warning [W0302] about a variable of a signature that is named as a type
    is, but for its first letter. *)

val too_large : at:Span.t -> string -> Diagnostic.t
(** {!Final.Too_large}, of the type of what is named here. *)
