(** What the translation into Core knows and counts. *)

open Basis

type t

val create : Ir.data list -> Ir.instance list -> Ir.foreign -> t
(** For a program with these data types, instances and foreign code. *)

val primitive : t -> Ir.Global.t -> Primitive.t
val instances : t -> Instance.table

val fresh : t -> string -> Span.t -> Ir.Local.t
(** A variable of that name, [""] for what has none in the program. Its [id] is negative: none that
    the resolver gave. *)

val define : t -> Ir.definition -> unit

val definitions : t -> Ir.definition list
(** As defined. *)

val field_types : t -> Ir.ty -> constructor:int -> Ir.ty list
(** Of a constructor of a data type at given arguments. *)

val constructors : t -> Ir.Global.t -> int
(** How many the data type has. *)
