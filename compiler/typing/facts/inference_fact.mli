(** Facts that inference reports about the types and units of expressions. *)

open Basis

type mismatch = {
  subject : Resolve.Ir.expr option;  (** the expression that has the wrong type, if there is one *)
  at : Span.t;
  expected : Expected.t;
  found : Type.t;
  clash : Unify.clash;  (** why {!Unify.types} cannot unify the two types *)
}

type t =
  | Mismatch of mismatch
  | Exchanged_pair of {
      at : Span.t;
      expected : Expected.t;
      first : Resolve.Ir.expr * Type.t;
      second : Resolve.Ir.expr * Type.t;
    }  (** each component has the type that the other should have *)
  | Not_a_function of {
      head : Resolve.Ir.expr;
      position : int;  (** position of the argument, counted from 1 *)
      given : int;  (** the number of arguments of the whole application *)
      argument : Resolve.Ir.expr;
      ty : Type.t;  (** the type of the head after the preceding arguments *)
    }  (** the head cannot take this argument *)
  | Negative_argument of {
      minus : Span.t;
      operand : Resolve.Ir.expr option;  (** the expression after the minus sign *)
      function_ : Resolve.Ir.expr;
      ty : Type.t;
    }  (** [f -1] *)
  | Not_a_signal_function of { head : Resolve.Ir.expr; ty : Type.t }  (** before [-<] *)
  | Too_many_parameters of {
      name : string option;  (** the definition's name *)
      at : Span.t;  (** the first parameter that the type does not allow *)
      parameters : Resolve.Ir.pattern list;
      expected : Expected.t;  (** the definition's type *)
      result : Type.t;  (** the part of the definition's type after the allowed parameters *)
      allowed : int;
    }
  | Parameters_in_a_tuple of {
      name : string;
      at : Span.t;
      parts : Resolve.Ir.pattern list;
      expected : Expected.t;
    }  (** [f (x, y) = …], where the type requires separate parameters *)
  | Lacking_types of {
      name : string;
      at : Span.t;
      expected : Expected.t;
      lacking : (string * Type.t) list;  (** the parameters whose types are missing *)
    }  (** [f d = proc i -> …] with the signature [f :: SF a b] *)
  | Variable_like_a_type of {
      at : Span.t;  (** the signature *)
      variable : Ir.variable;
      type_ : string;  (** the type that the programmer probably meant *)
    }  (** a warning *)
  | Matched_twice of {
      constructor : Ir.Global.t;
      first : Resolve.Ir.pattern;
      second : Resolve.Ir.pattern;
      missing : string;  (** a constructor that no branch matches *)
    }
      (** two branches of a [case] match the same constructor, and the second branch contains an
          error *)
  | Parameters_in_other_order of {
      head : Resolve.Ir.expr;
      name : string;  (** [foldl] or [scanl] *)
      first : Resolve.Ir.pattern;
      second : Resolve.Ir.pattern;
    }  (** [foldl (\x n -> n + x) 0 xs]: the function would fit if its parameters were swapped *)
  | Mapped_range of { at : Span.t; head : Span.t; arguments : Resolve.Ir.expr list }
      (** [map x 0 1023 0 255], as in Arduino *)
  | Missing_field of {
      field : Syntax.Ir.name;
      record : Resolve.Ir.expr;
      ty : Type.t;  (** the type of [record] *)
      known : string list;  (** the fields that this type has *)
    }
  | Unknown_field of { field : Syntax.Ir.name; record : Resolve.Ir.expr }
      (** no type in scope has this field *)
  | Ambiguous_field of {
      field : Syntax.Ir.name;
      record : Resolve.Ir.expr;  (** the type of the record is unknown *)
      types : Ir.Global.t list;  (** the types that have this field *)
    }
  | Field_of_argument of {
      at : Span.t;
      field : Syntax.Ir.name;
      record : Resolve.Ir.expr;
      function_ : string;
    }  (** [robotPose i.heading], meant as a field of [robotPose i] *)
  | Idle_constraint of { at : Span.t; variable : Ir.variable; ty : Span.t }
      (** a constraint on a variable that the type at this place does not mention *)
  | Constraint_on_type of { at : Span.t; ty : Type.t }
      (** a constraint on something other than a variable *)
  | Unknown_size of {
      at : Span.t;
      of_ : string;  (** the definition that is used here *)
      variable : string option;
          (** the size variable in its signature, if the signature is in the same file *)
    }  (** nothing determines the size of an array *)
  | Polymorphic_value of {
      name : string option;  (** [None] for an annotated expression *)
      at : Span.t;
      signature : Span.t;
      ty : Type.t;
    }  (** a local definition that has type variables but is not a function *)
  | Over_a_turn of Resolve.Ir.expr
      (** a constant larger than a full turn where an angle in radians is expected; a warning *)
  | In_degrees of {
      angle : Resolve.Ir.expr;
          (** a product with the factor 180/π where an angle in radians is expected *)
      factors : Resolve.Ir.expr list;  (** its other factors; not empty *)
      beside : Resolve.Ir.expr option;  (** the operator's other operand, which is in radians *)
    }  (** a warning *)
  | Idle_return of {
      statement : Resolve.Ir.expr;
      is_choice : bool;  (** whether it chooses between several uses of [return] *)
      next : Span.t option;  (** the statement after it *)
    }  (** a [return] that is not the last statement of a [do]; a warning *)
  | Unreachable_statement of { at : Span.t; endless : Resolve.Ir.expr }
      (** a warning: the preceding statement is a task that never ends; [endless] is its head *)
  | Long_array of { at : Span.t; length : int; longest : int }
  | Empty_array of Span.t
  | Int_out_of_range of {
      at : Span.t;
      number : Resolve.Ir.number;
      same_bits : int32 option;  (** the [Int] that has the same bits as the number in the source *)
    }
  | Number_out_of_range of { at : Span.t; number : Resolve.Ir.number; real : Real.t }
