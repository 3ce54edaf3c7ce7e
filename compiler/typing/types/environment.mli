(** The declared types, constructors and units of a program, as inference uses them. {!Declarations}
    fills this table; afterwards, it is read-only. *)

type t

val create : unit -> t

(** {1 Units} *)

type unit_ = { measure : Units.t; scale : Basis.Exact.t }

val add_unit : t -> Ir.Global.t -> unit_ -> unit
val unit_ : t -> Ir.Global.t -> unit_

val named_unit : t -> Units.t -> string option
(** The name of a declared unit that equals this one, such as [N]. Only units of scale 1 with at
    least three base units have an entry, because a shorter unit ([1/s]) is clearer than its name
    ([Hz]). *)

(** {1 Types} *)

type parameters = { units : Units.rigid list; types : Type.rigid list }
type definition = Alias of Type.t | Data of Ir.data | Builtin | Foreign
type type_ = { parameters : parameters; definition : definition }

val add_type : t -> Ir.Global.t -> type_ -> unit
val type_ : t -> Ir.Global.t -> type_

val built_in : string -> Ir.Global.t
(** The global name of a built-in type or constructor. *)

val array : Ir.Global.t

val array_of : Type.t -> Type.t -> Type.t
(** [Array size element] *)

val task : Ir.Global.t

val task_of : Type.t -> Type.t -> Type.t -> Type.t
(** [Task input output result] *)

val as_task : Type.t -> (Type.t * Type.t * Type.t) option
(** The input, output and result types, if the type is a task. *)

val is_task : Type.t -> bool
val is_event : Type.t -> bool

val sequence : Ir.Global.t
(** The primitive for [do] notation: it takes a task and the function that returns the next task.
    Its name is a keyword, so programs cannot refer to it. *)

(** {1 Classes} *)

type class_ = {
  superclasses : Ir.class_ list;  (** including indirect ones *)
  place : Basis.Span.t;
}

val add_class : t -> Ir.Global.t -> class_ -> unit

val superclasses : t -> Ir.class_ -> Ir.class_ list
(** Also handles the built-in classes. *)

type instance = {
  context : (Ir.class_ * int) list;
      (** required classes, each with the index (from 0) of the type argument that must have an
          instance *)
  place : Basis.Span.t;
}

val add_instance : t -> Ir.Global.t -> Head.t -> instance -> unit
val instance : t -> Ir.Global.t -> Head.t -> instance option

val heads : t -> Ir.Global.t -> Head.t list
(** The type constructors that have an instance of the class. *)

(** {1 Constructors} *)

type constructor = private {
  ir : Ir.constructor;
  tycon : Ir.Global.t;
  scheme : Type.scheme;  (** the type of the constructor as a function of its fields *)
  positions : int Basis.String_table.t Lazy.t;  (** see {!position} *)
  own_types : Type.t array option Lazy.t;  (** see {!own_type} *)
}

val make_constructor : Ir.constructor -> tycon:Ir.Global.t -> Type.scheme -> constructor

val own_type : constructor -> int -> Type.t option
(** The type of the field with this index, if the constructor's type has no parameters. Takes
    constant time after the first call. *)

val position : constructor -> string -> int option
(** The index of a field, if the constructor has it. *)

val add_constructor : t -> constructor -> unit
val constructor : t -> Ir.Global.t -> constructor

val record_of : t -> Ir.Global.t -> constructor option
(** The constructor of a record type. *)

val field_names : t -> string list
(** The field names of all records, in alphabetical order. *)

val fields : constructor -> Type.t -> Type.t list * Type.t
(** Splits the constructor's instantiated function type into its field types and its result type. *)
