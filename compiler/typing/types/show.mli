(** Prints types and units in Frob syntax. *)

open Basis

(** {1 Final types} *)

val ty : Ir.ty -> string

val scheme : Ir.scheme -> string
(** The type with its context: [Eq a => a -> a -> Bool]. *)

val final_constraint : Ir.class_ -> Ir.ty -> string
(** For example [Eq (Maybe Int)]. *)

val unit_ : Ir.unit_ -> string
(** For example [m/s], [kg m/s^2] or [1]. *)

(** {1 Types in messages}

    Unsolved variables get names in the usual style: [a], [b] for types, [u], [v] for units, [n] for
    representations. A name is the same in all texts of one message and differs from all names that
    a signature uses. *)

type words
(** The variable names chosen so far in one message, and the context that the message may mention.
*)

(** A construct that has type variables. A [Signature] is that of the definition with this name. A
    [Class] or an [Instance] is that of the class with this name. *)
type construct = Signature of string | Class of string | Instance of string

type owned = { by : construct; place : Span.t }

type place = {
  environment : Environment.t;
  sources : Source.t;
  inputs : (string * Type.t) list;  (** input signals of the enclosing proc *)
  needs_class : Type.t -> bool;  (** whether some use requires a class for this type *)
  definition : Resolve.Ir.Local.t -> Resolve.Ir.expr option;
      (** the value of a local variable without parameters *)
  local : Resolve.Ir.Local.t -> Type.t option;  (** the type of a local variable *)
  unit_ : Resolve.Ir.unit_ -> Units.t option;  (** a written unit without variables *)
  fields : Type.t -> (string * string list) option;
      (** the constructor and the fields of a record type *)
  field_of : Type.t -> of_:Type.t -> string option;
      (** the field of the record whose data type has the same constructor as the second type, if
          there is exactly one *)
  choices : Type.t -> string list;
      (** the constructors of an enumeration with few cases; otherwise the empty list *)
  declared : Resolve.Ir.Global.t -> Type.t option;  (** the declared type of a definition *)
  named : string -> Type.t list;  (** the types of all definitions with this name *)
  values : Type.t -> file:string -> string list;
      (** the definitions without parameters of this file that have this type *)
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

val nowhere : Environment.t -> place
(** A context that answers no question about the program. *)

val words : place -> words
val sources : words -> Source.t
val environment : words -> Environment.t

val quote : words -> Span.t -> string option
(** The source text in this span, if it is short. *)

val argument : words -> Resolve.Ir.expr -> string option
(** The source text of the expression, if it is short, in parentheses if it needs them as an
    argument. *)

val argument_or : string -> words -> Resolve.Ir.expr -> string
(** Like {!argument}, or this text in place of a long one. *)

val needs_class : words -> Type.t -> bool
val definition : words -> Resolve.Ir.Local.t -> Resolve.Ir.expr option
val local : words -> Resolve.Ir.Local.t -> Type.t option
val unit_written : words -> Resolve.Ir.unit_ -> Units.t option
val binding : words -> Resolve.Ir.Global.t -> Resolve.Ir.binding option
val local_function : words -> Resolve.Ir.Local.t -> Resolve.Ir.binding option
val parameter : words -> Resolve.Ir.Local.t -> (Resolve.Ir.binding * int) option
val unnamed_input : words -> Span.t option
val declared_type : words -> Resolve.Ir.Global.t -> Type.t option
val named : words -> string -> Type.t list
val values : words -> Type.t -> file:string -> string list

val inputs : words -> (string * Type.t) list
(** The input signals of the enclosing proc. *)

val fields : words -> Type.t -> (string * string list) option
val field_of : words -> Type.t -> of_:Type.t -> string option
val choices : words -> Type.t -> string list
val owner : words -> Ir.variable -> owned option
val makers : words -> Type.t -> of_:Type.t -> string list

val declared : words -> Resolve.Ir.Global.t -> string option
(** The type that the signature contains. *)

val is_input : words -> string -> bool
(** Is this the name of an input of the enclosing proc? *)

val signal : words -> Type.t -> string option
(** An input of the enclosing proc that may have this type. *)

val tell_apart : words -> Type.t list -> unit
(** From now on, shows the module name for data types whose name occurs in several modules among
    these types. *)

val namesakes : words -> string list
(** The names that are shown with their module. *)

val type_ : words -> Type.t -> string
(** Uses the type's alias if it has one. *)

val quoted : words -> Type.t -> string
(** The type in backticks; the alias of a number is followed by its unit, as in [`Velocity` (m/s)].
*)

val is_any_number : Type.t -> bool
(** Is the type known only to be a number? If so, its text does not contain variable names. *)

val described : words -> Type.t -> string
(** A type as part of a sentence: quoted, or [a number]. *)

val class_ : Ir.class_ -> string

val constraint_ : words -> Ir.class_ -> Type.t -> string
(** For example [Eq (Maybe a)]. *)

val measure : words -> Units.t -> string
val representation : words -> Type.representation -> string
