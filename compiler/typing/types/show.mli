(** Types and units as a programmer would write them. *)

open Basis

(** {1 What inference found} *)

val ty : Ir.ty -> string

val scheme : Ir.scheme -> string
(** With its context: [Eq a => a -> a -> Bool]. *)

val unit_ : Ir.unit_ -> string
(** [m/s], [kg m/s^2], [1]. *)

(** {1 Types in messages}

    Variables still to be found are named as a programmer would: [a], [b] for types, [u], [v] for
    units, [n] for representations, the same in all texts of one message, and apart from the names a
    signature uses. *)

type words
(** The names given so far in one message, and what it may speak of. *)

type place = {
  sources : Source.t;
  inputs : (string * Type.t) list;  (** the signals that come into the proc around *)
  needs_class : Type.t -> bool;  (** something was used that asks for one *)
  definition : Resolve.Ir.Local.t -> Resolve.Ir.expr option;
      (** the value of a local that has no parameters *)
  fields : Type.t -> (string * string list) option;  (** a record's constructor, and its fields *)
  choices : Type.t -> string list;
      (** the constructors of a type, if it has a few, and none of them has parts *)
  declared : Resolve.Ir.Global.t -> Type.t option;  (** the type of a definition *)
  makers : Type.t -> of_:Type.t -> string list;
      (** constructors of the first type that have a part of the second, with their parts *)
}

val words : ?place:place -> named_unit:(Units.t -> string option) -> unit -> words
(** [named_unit] knows units with a name of their own, as [N] for [kg m/s^2]. *)

val quote : words -> Span.t -> string option
(** What is written there, if it is short. *)

val needs_class : words -> Type.t -> bool
val definition : words -> Resolve.Ir.Local.t -> Resolve.Ir.expr option
val fields : words -> Type.t -> (string * string list) option
val choices : words -> Type.t -> string list
val makers : words -> Type.t -> of_:Type.t -> string list

val declared : words -> Resolve.Ir.Global.t -> string option
(** The type as its signature has it. *)

val is_input : words -> string -> bool
(** Comes into the proc around under this name. *)

val signal : words -> Type.t -> string option
(** An input of the proc around that may be of this type. *)

val tell_apart : words -> Type.t list -> unit
(** Data types among these that have one name, of several modules, are shown with the module's. *)

val namesakes : words -> string list
(** Their names. *)

val type_ : words -> Type.t -> string
(** By its alias where it has one. *)

val quoted : words -> Type.t -> string
(** In backticks; a number's alias is followed by the unit, as [`Velocity` (m/s)]. *)

val described : words -> Type.t -> string
(** A type in a sentence: quoted, or [a number]. *)

val class_ : Ir.class_ -> string

val constraint_ : words -> Ir.class_ -> Type.t -> string
(** As [Eq (Maybe a)]. *)

val measure : words -> Units.t -> string
val representation : words -> Type.representation -> string
