(** The room of values and structs on a 64-bit machine, where a C compiler lays out the members of a
    struct in order, each at the next multiple of its alignment, and pads the whole to a multiple of
    its own. Structs of the user's C have a size that we do not know: they count as none. *)

type t = { bytes : int; alignment : int }

val of_value : Basis.Real.t -> Flow.Ir.sum array -> Ir.ty -> t

val foreign : t
(** A struct of the user's C, of which the largest alignment is taken. *)

val scalars : Flow.Ir.sum array -> Ir.ty -> int
(** How many numbers, truth values and tags a value is made of. *)

val numbers : Flow.Ir.sum array -> Ir.ty -> int
(** How many of these are Floats. *)

val run : int -> t -> t
(** So many, one after another. *)

val of_members : t list -> int list * t
(** The offsets of the members of a struct, and the struct. *)

val of_alternatives : t list -> t
(** A union. *)
