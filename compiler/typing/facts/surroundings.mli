(** The context of a fact in the program, for use in messages. *)

open Basis

(** A construct that has type variables. The string is the name of the definition that has the
    signature, or of the class. *)
type construct = Signature of string | Class of string | Instance of string

type owned = { by : construct; place : Span.t }

type enclosing = {
  expr : Resolve.Ir.expr;
  wanted : Type.t option;  (** the type that it must have, if the context determines it *)
}

type t = {
  environment : Environment.t;
  sources : Source.t;
  inputs : (string * Type.t) list;  (** input signals of the enclosing proc *)
  enclosing : enclosing list;  (** the enclosing applications and records, innermost first *)
  needs_class : Type.t -> bool;  (** whether some use requires this type to have a class *)
  definition : Resolve.Ir.Local.t -> Resolve.Ir.expr option;
      (** the value of a local variable without parameters *)
  local : Resolve.Ir.Local.t -> Type.t option;  (** the type of a local variable *)
  unit_ : Resolve.Ir.unit_ -> Units.t option;
      (** the unit in base units; [None] if it contains variables *)
  fields : Type.t -> (string * string list) option;
      (** the constructor and the fields of a record type *)
  field_of : Type.t -> of_:Type.t -> string option;
      (** for a record type, the field whose type has the same type constructor as [of_]; [None]
          unless there is exactly one such field *)
  field_type : Type.t -> string -> Type.t option;  (** the type of this field of a record *)
  choices : Type.t -> string list;
      (** the constructors of an enumeration with few cases; otherwise the empty list *)
  declared : Resolve.Ir.Global.t -> Type.t option;  (** the declared type of a definition *)
  named : string -> (Resolve.Ir.Global.t * Type.t) list;
      (** all definitions with this name, with their types *)
  values : Type.t -> file:string -> string list;
      (** the definitions in this file that have this type and no parameters *)
  binding : Resolve.Ir.Global.t -> Resolve.Ir.binding option;  (** a top-level definition *)
  local_function : Resolve.Ir.Local.t -> Resolve.Ir.binding option;
      (** the definition of a local variable with parameters *)
  parameter : Resolve.Ir.Local.t -> (Resolve.Ir.binding * int) option;
      (** the top-level definition that has this parameter, and the index of the parameter *)
  unnamed_input : Span.t option;
      (** the [_] in place of an input of the enclosing proc, if there is one *)
  makers : Type.t -> of_:Type.t -> string list;
      (** constructors of the first type that have a field of type [of_], shown with their fields *)
  owner : Ir.variable -> owned option;  (** the construct that introduces this type variable *)
}
