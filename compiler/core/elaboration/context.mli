(** The state of the translation into Core. *)

open Basis

type t

val create : Ir.data list -> Ir.instance list -> Ir.foreign -> t
(** The state for a program with these data types, instances and foreign declarations. *)

val primitive : t -> Ir.Global.t -> Primitive.t
val instances : t -> Instance.table

val fresh : t -> string -> Span.t -> Ir.Local.t
(** A new variable with this name, which is [""] if the variable has no name in the program. Its
    [id] is negative, so it differs from the resolver's ids. *)

val define : t -> Ir.definition -> unit

val definitions : t -> Ir.definition list
(** The definitions that {!define} added, oldest first. *)

val field_types : t -> Ir.ty -> constructor:int -> Ir.ty list
(** The field types of a constructor, for this instance of its data type. *)

val constructors : t -> Ir.Global.t -> int
(** The number of constructors of the data type. *)
