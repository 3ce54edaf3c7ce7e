(** The declared types, constructors and units of a program, as inference uses them. Filled by
    {!Declarations}, read-only afterwards. *)

type t

val create : unit -> t

(** {1 Units} *)

type unit_ = { measure : Units.t; scale : Basis.Exact.t }

val add_unit : t -> Ir.Global.t -> unit_ -> unit
val unit_ : t -> Ir.Global.t -> unit_

val named_unit : t -> Units.t -> string option
(** A unit of scale 1 with a name of its own and at least three base units in it, as [N]: shorter
    ones ([1/s]) say more than the name ([Hz]). *)

(** {1 Types} *)

type parameters = { units : Units.rigid list; types : Type.rigid list }
type definition = Alias of Type.t | Data of Ir.data | Builtin | Foreign
type type_ = { parameters : parameters; definition : definition }

val add_type : t -> Ir.Global.t -> type_ -> unit
val type_ : t -> Ir.Global.t -> type_

val built_in : string -> Ir.Global.t
(** The global of a built-in type or constructor. *)

val array : Ir.Global.t

val array_of : Type.t -> Type.t -> Type.t
(** [Array size element] *)

val task : Ir.Global.t

val task_of : Type.t -> Type.t -> Type.t -> Type.t
(** Of input, output and result. *)

val as_task : Type.t -> (Type.t * Type.t * Type.t) option
(** Its input, output and result, if the type is that of a task. *)

val is_task : Type.t -> bool
val is_event : Type.t -> bool

val sequence : Ir.Global.t
(** The primitive that [do] stands for: a task, then the function that gives the task after it. Its
    name is a keyword, so no program can say it. *)

(** {1 Classes} *)

type class_ = { superclasses : Ir.class_ list;  (** and theirs *) place : Basis.Span.t }

val add_class : t -> Ir.Global.t -> class_ -> unit
val class_ : t -> Ir.Global.t -> class_

val superclasses : t -> Ir.class_ -> Ir.class_ list
(** Also of the built-in classes. *)

type instance = {
  context : (Ir.class_ * int) list;  (** classes of what the head is applied to, from 0 *)
  place : Basis.Span.t;
}

val add_instance : t -> Ir.Global.t -> Head.t -> instance -> unit
val instance : t -> Ir.Global.t -> Head.t -> instance option

val heads : t -> Ir.Global.t -> Head.t list
(** Of the class's instances. *)

(** {1 Constructors} *)

type constructor = {
  ir : Ir.constructor;
  tycon : Ir.Global.t;
  scheme : Type.scheme;  (** of the constructor as a function of its fields *)
}

val add_constructor : t -> constructor -> unit
val constructor : t -> Ir.Global.t -> constructor

val record_of : t -> Ir.Global.t -> constructor option
(** The constructor of a type that is a record. *)

val field_names : t -> string list
(** Of all records, in alphabetical order. *)

val fields : constructor -> Type.t -> Type.t list * Type.t
(** Of an instance of its scheme's type: its fields and its result. *)
