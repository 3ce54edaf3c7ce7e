(** Input for a program: its value at some instants.

    Mostly these have times, as in a file for [frobc trace]. Or each has the dt that the program's
    step is given: any number, of which the language says what it means. *)

type row = {
  time_ns : int;
  dt : float option;  (** in seconds; if there is none, the difference of the times *)
  value : Interp.Value.t;
  cells : string list;  (** the value's, in the order of the columns *)
}

type param = {
  line : string;  (** before the header *)
  cell : string;
  setting : Core.Ir.Global.t * Interp.Value.t;
}
(** A parameter of the program, and its value. *)

type t

val params : t -> param list
(** None, unless it is made {!with_params}; else all of the program's, in its order. *)

val with_params : param list -> t -> t

val make : Interp.Shape.t -> (int * Interp.Value.t) list -> t
(** Of times in nanoseconds, not falling, and values of this shape. *)

val with_dt : Basis.Real.t -> Interp.Shape.t -> (float * Interp.Value.t) list -> t
(** Of dts, in seconds and of this precision, and values. With singles it is one for [NAME_step] of
    a program in single precision. *)

val read : Interp.Shape.t -> string -> (t, string) result
(** From CSV as {!csv} writes it. *)

val has_shape : Interp.Shape.t -> t -> bool
(** Whether it has the columns of this shape, with cells of the same kinds. *)

val rows : t -> row list

val has_dt : t -> bool
(** Whether it is made {!with_dt}. *)

val precision : t -> Basis.Real.t
(** Of the seconds that a step is given: double, unless it has dts that are singles. *)

val seconds : t -> float list
(** What a step is given at each row. *)

val first_rows : int -> t -> t
(** No more than so many. *)

val without : int -> t -> t
(** All rows but one, which counts from 0. *)

val csv : t -> string
(** As [frobc trace] reads it; in one with dts these stand in place of the times. *)

val trace : Interp.Shape.t -> (int * Interp.Value.t) list -> string
(** The output at these times as [frobc trace] writes it. *)
