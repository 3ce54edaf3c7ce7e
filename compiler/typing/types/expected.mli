(** The type that an expression is expected to have, and the reason. *)

open Basis

type decider = {
  place : Span.t;
  decides : Type.t;  (** the type of this argument *)
  a_size : bool;  (** whether the shared variable is an array size *)
}
(** An earlier argument whose type shares a variable with the parameter's type. *)

type number = {
  negative : bool;
  digits : string;
  unit_ : Resolve.Ir.unit_ option;
  at : Span.t;  (** the place of the number without its sign *)
}
(** A number in the program. *)

type completed = {
  ty : Type.t;
  units : Units.t list;  (** the unit arguments of [ty] *)
  is_example : bool;
      (** whether some of these units are undetermined and therefore only examples *)
  fields : (Syntax.Ir.name * number option * Units.t option) list;
      (** for each field, the number that it is set to, and the unit that this number needs *)
}
(** A record, with the unit that each of its numbers must have for the record to have the type [ty].
*)

(** The reason why an expression must have a certain type. *)
type reason =
  | Unknown
  | Signature of { name : string; at : Span.t }
  | Annotation of Span.t
  | Parameter of {
      callee : string option;
      head : Resolve.Ir.expr option;  (** the applied expression *)
      at : Span.t;
      position : int;
      decided_by : decider list;
      takes : int;  (** number of the callee's parameters *)
      given : Resolve.Ir.expr list;  (** all arguments of the call *)
      before : string option;
          (** the operator that follows the application, if this is its last argument *)
      of_local : Span.t option;
          (** the callee's first application, if the callee is a local function without a signature
          *)
    }
  | Operand of { operator : string; other : Resolve.Ir.expr; other_type : Type.t }
      (** one operand must match the other *)
  | Branch of Span.t  (** an earlier branch has this type *)
  | Condition
  | Element of Span.t  (** the first element of the array has this type *)
  | Value of Span.t  (** for a pattern: the matched value has this type *)
  | Pattern of Span.t  (** for a value: the pattern that it is matched against has this type *)
  | Statement of Span.t option
      (** for a statement of a [do]: the place that determines the input and output of its tasks *)
  | Last_statement of reason
      (** for the last statement: the reason that applies to the whole [do] *)
  | Uses of { name : string; at : Span.t }  (** other uses of the name being defined *)
  | Field of {
      name : string;
      at : Span.t;
      constructor : Environment.constructor option;
          (** the constructor of the record, if the units of its fields depend on each other *)
      completed : completed Lazy.t option;
          (** the record with all its units, computed only when a message needs it. Present if the
              units of the record's fields depend on each other, the value of this field is a
              number, and either the number has no unit or the expected units are known *)
    }
  | Output of reason
      (** for the output of a signal function: the reason that applies to the signal function *)

(** A part of a type. The components of a tuple are counted from 1. *)
type part = Of_parameter | Of_result | Of_input | Of_output | Of_tuple of int | Of_array | Of_data

type t = {
  ty : Type.t;
  because : reason;
  parts : part list;
      (** the path to this type in the type that the reason is about, innermost part first; empty if
          [ty] is that whole type *)
}
