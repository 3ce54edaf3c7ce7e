(** Numbers that are written without a unit, and names that are defined as such numbers. *)

open Basis

type t = {
  digits : string;  (** without the sign *)
  negative : bool;
  unit_ : Resolve.Ir.unit_ option;
  at : Span.t;  (** the literal *)
  name : string option;  (** the constant or local name that is defined as the literal *)
  signature : Span.t option;  (** the signature of the constant *)
  of_record : bool;  (** [name] is a field, so its declaration needs the unit too *)
}

val literal : Wording.t -> Resolve.Ir.expr -> t option
(** The literal, if the expression is a literal other than zero or a name defined as one. *)

val factor : Wording.t -> Resolve.Ir.expr -> (t * int) list
(** The named constants without a unit that scale this expression, each with its exponent, 1 or -1.
    In a product, only the first such constant counts; in a sum, one for each operand. The list is
    empty if an operand of a sum has no such constant. Looks through the definitions of names and
    the fields of constant records. *)

val written_factor : Wording.t -> Resolve.Ir.expr -> (t * int) list
(** Like {!factor}, for number literals that are written in the expression itself, with or without a
    unit. *)

val gain : Wording.t -> Resolve.Ir.expr -> (t * int) list
(** Like {!factor}, but for numbers whose unit, apart from angles, has only negative exponents, such
    as [1/s] and [rad/(m s)]. The numbers may have names or be written in the expression. *)

val is_per_millisecond : Wording.t -> Resolve.Ir.expr -> bool
(** Is the expression a number in [[ms^-1]], probably intended as metres per second? *)

val own_function : Wording.t -> Resolve.Ir.expr -> Resolve.Ir.binding option
(** The definition of a function that has parameters and no signature, if it is in the same file as
    the expression. *)

val value : Wording.t -> Resolve.Ir.expr -> Resolve.Ir.expr
(** The definition of a name, the result of a function without a signature, or the expression
    itself. *)

val give : Wording.t -> t -> string -> Diagnostic.t -> Diagnostic.t
(** Labels the literal, and suggests adding this unit to it. *)

val give_literals : (t * string) list -> Diagnostic.t -> Diagnostic.t
(** Suggests adding a unit to each of several literals in a single fix. *)
