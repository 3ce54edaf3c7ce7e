(** Reasons for expected types. *)

val part : Expected.part -> Expected.t -> Type.t -> Expected.t
(** The expectation for a part of the expression, which must have this type. *)

val components : Expected.t -> Type.t list -> Expected.t list
(** The expectations for the components of a tuple, which must have these types. *)
