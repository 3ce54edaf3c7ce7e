(** The input of a program: its values at some instants.

    Most recordings have times, as in a file for [frobc trace]. Others have a dt for each step,
    which may be any number; the language defines what the program does with it. *)

type row = {
  time_ns : int;
  dt : float option;  (** in seconds; if None, the time since the previous row *)
  value : Interp.Value.t;
  cells : string list;  (** the cells of the value, in the order of the columns *)
}

type param = {
  line : string;  (** the line above the header that sets it *)
  cell : string;
  setting : Core.Ir.Global.t * Interp.Value.t;
}
(** A parameter of the program, with its value. *)

type t

val params : t -> param list
(** The parameters set by {!with_params}: all of the program's parameters, in order. Empty if
    {!with_params} was not called. *)

val with_params : param list -> t -> t

val make : Interp.Shape.t -> (int * Interp.Value.t) list -> t
(** A recording with nondecreasing times in nanoseconds, and values of this shape. *)

val with_dt : Basis.Real.t -> Interp.Shape.t -> (float * Interp.Value.t) list -> t
(** A recording with dts, in seconds and of this precision, and values. A recording with
    single-precision dts is for [NAME_step] of a single-precision program. *)

val read : Interp.Shape.t -> string -> (t, string) result
(** Parses CSV in the format of {!csv}. *)

val has_shape : Interp.Shape.t -> t -> bool
(** Whether it has the columns of this shape, with cells of the same types. *)

val rows : t -> row list

val has_dt : t -> bool
(** Whether it was made with {!with_dt}. *)

val precision : t -> Basis.Real.t
(** Precision of the dt passed to steps: double, unless the dts are singles. *)

val seconds : t -> float list
(** The dt passed to the step at each row. *)

val first_rows : int -> t -> t
(** The first [n] rows, or all if there are fewer. *)

val without : int -> t -> t
(** All rows except the one with this index, from 0. *)

val csv : t -> string
(** The format that [frobc trace] reads. In a recording with dts, these take the place of the times.
*)

val trace : Interp.Shape.t -> (int * Interp.Value.t) list -> string
(** The output at these times in the format that [frobc trace] writes. *)
