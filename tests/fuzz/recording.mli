(** Input for a program: its value at some instants. *)

type row = {
  time_ns : int;
  value : Interp.Value.t;
  cells : string list;  (** the value's, in the order of the columns *)
}

type t

val make : Interp.Shape.t -> (int * Interp.Value.t) list -> t
(** Of times in nanoseconds, not falling, and values of this shape. *)

val read : Interp.Shape.t -> string -> (t, string) result
(** From CSV as {!csv} writes it. *)

val has_shape : Interp.Shape.t -> t -> bool
(** Whether it has the columns of this shape, with cells of the same kinds. *)

val rows : t -> row list

val first_rows : int -> t -> t
(** No more than so many. *)

val without : int -> t -> t
(** All rows but one, which counts from 0. *)

val csv : t -> string
(** As [frobc trace] reads it. *)

val trace : Interp.Shape.t -> (int * Interp.Value.t) list -> string
(** The output at these times as [frobc trace] writes it. *)
