(** What is said of the vectors of the library's geometry where numbers or tuples stand, and of
    numbers where vectors do. Each is a hint, or a part of one, for what was expected. *)

val vector : Show.words -> ?elements:Resolve.Ir.expr list -> Type.t -> string option
(** How a vector of this type is built, perhaps of these. *)

val vector_fields :
  Show.words -> subject:Resolve.Ir.expr option -> Type.t -> Type.t list -> string option
(** Likewise, of a tuple of these types. *)

val vector_operator : Expected.t -> string option
(** What vectors have for the operator of numbers that expects one. *)
