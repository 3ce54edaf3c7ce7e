(** Size and alignment of values and structs on a 64-bit machine. A C compiler lays out the members
    of a struct in order, each at the next multiple of its alignment, and pads the struct to a
    multiple of its own alignment. Structs declared in the user's C code have an unknown size, which
    counts as 0. *)

type t = { bytes : int; alignment : int }

val of_value : Basis.Real.t -> Flow.Ir.sum array -> Ir.ty -> t

val foreign : t
(** A struct declared in the user's C code. Its alignment is assumed to be the largest possible one.
*)

val scalars : Flow.Ir.sum array -> Ir.ty -> int
(** The number of scalars in a value: numbers, Bools and tags. *)

val numbers : Flow.Ir.sum array -> Ir.ty -> int
(** The number of scalars that are Floats. *)

val run : int -> t -> t
(** A block of this many identical members, one after another. *)

val of_members : t list -> int list * t
(** The offsets of a struct's members, and the size and alignment of the whole struct. *)

val of_alternatives : t list -> t
(** The size and alignment of a union of these members. *)
