(** Facts that the checks of declarations report. *)

open Basis

(** Why a type has no counterpart in C. *)
type obstacle =
  | Representation  (** a variable that ranges over Int and Float *)
  | Text
  | Compile_time  (** its values exist only at compile time *)
  | Type_of_c of string  (** a type variable with the name of a C type *)
  | Several_types  (** any other type variable *)

(** Reasons why C code cannot be imported with its declared type. *)
type refusal =
  | Signal_function_with_parameters
  | Not_a_signal_function of Ir.ty
  | Signal_function  (** declared as a function *)
  | No_argument of Ir.ty
  | Type_classes
  | Not_passed of { culprit : Ir.ty; obstacle : obstacle; to_c : bool }
      (** a value of the type [culprit] would be passed to C ([to_c]) or returned by C *)

type imported = { ty : Ir.ty; at : Span.t }

type t =
  | Scale_out_of_range of Resolve.Ir.unit_declaration
  | Param of { at : Span.t; name : string; scheme : Ir.scheme }
      (** a program parameter that is neither a number nor a Bool *)
  | Foreign of { declared : Resolve.Ir.primitive; refusal : refusal }
  | Imported_twice of { symbol : string; this : imported; first : imported }
      (** two imports of the same C function with different types *)
  | Method_without_variable of { method_ : Resolve.Ir.method_; variable : Ir.variable }
      (** the method's type does not contain the class's variable *)
  | Constrained_variable of { constraint_ : Resolve.Ir.constraint_; variable : Ir.variable }
      (** the context of a method constrains the class's variable *)
  | Built_in_class of Resolve.Ir.instance
      (** an instance of a built-in class, which cannot have instances *)
  | Instance_head of { instance : Resolve.Ir.instance; head : Type.t }
      (** the instance head is not a type constructor applied to distinct variables *)
  | Second_instance of { instance : Resolve.Ir.instance; head : Type.t; first : Span.t }
  | Missing_methods of {
      instance : Resolve.Ir.instance;
      head : Type.t;
      missing : (Ir.Global.t * Span.t) list;
          (** each missing method, with the place of its signature *)
    }
