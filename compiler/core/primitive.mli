(** The built-in primitives.

    Each primitive is declared with its type in the standard library
    ([primitive sin :: Float -> Float]) and has a row in {!Primitive_table}. {!Specialize} and the
    interpreter implement its meaning. *)

type t =
  (* on numbers of any representation *)
  | Add
  | Subtract
  | Multiply
  | Negate
  | Absolute
  | Signum
  (* on Float *)
  | Divide
  | Power  (** [**] *)
  | Power_literal of int  (** [e ^ k]; not declared in the library, but created by the syntax *)
  | Elementary of elementary
  (* on Int *)
  | Div
  | Mod
  | Bitwise of bitwise
  (* conversions *)
  | To_float
  | Round
  | Floor
  | Ceiling
  | Truncate
  (* structural comparison of any data without functions *)
  | Equal
  | Not_equal
  | Less
  | Less_equal
  | Greater
  | Greater_equal
  | Minimum
  | Maximum
  (* on Bool *)
  | And
  | Or
  (* on arrays; [a ! k] is {!Ir.Index} *)
  | At
  | Length
  | Replace
  | Generate
  | Map
  | Imap
  | Zip_with
  | Foldl
  | Scanl
  (* signal functions *)
  | Delay
  | Time
  | Time_since
  | Step_time
  | Ticks
  | Integral
  | Derivative
  | Switch
  | Delayed_switch
  | Recurring_switch
  | Delayed_recurring_switch
  | Map_sf  (** runs a signal function for each element of an array *)
  | Parallel  (** [parZ] *)
  | Initially
  | On_event
  (* tasks *)
  | Make_task
  | Until_right
  | Return
  | Sequence  (** [do]: a task, and the function that returns the next task *)
  | Run_task
  (* programs *)
  | Reactimate  (** [SF i o -> Program i o] *)
  | Node  (** [Float -> SF i o -> Program i o]: a ROS 2 node with topics, and its rate *)
  | Ending  (** tells the program's host whether the program has ended, and with what result *)
  (* controls on the operator's console, by label; see {!Console} *)
  | Console of console
  (* drawings, for the library's Display module *)
  | Text_of
  | Blank
  | Drawn
  | Together
  (* declared by the program *)
  | Foreign of foreign  (** C code *)

(** The runtime's elementary functions ([frob/elementary.h]), and functions that IEEE 754 defines
    exactly: [Sqrt], rounding down or up to an integer as a Float (C's [floor] and [ceil]), and
    conversion to whole nanoseconds. *)
and elementary =
  | Sqrt
  | Floor_float
  | Ceiling_float
  | Nanoseconds
      (** converts seconds to whole nanoseconds in Float's precision, rounding ties to even; a
          negative number becomes 0, and NaN remains NaN *)
  | Hypot
  | Exp
  | Log
  | Sin
  | Cos
  | Tan
  | Asin
  | Acos
  | Atan
  | Atan2

(** The first argument is a label, except for [Map], because there is only one map. The limits and
    initial value of a knob, or the initial position of a toggle, follow. The last argument is the
    console. *)
and console = Button | Hold | Knob | Toggle | Map | Camera | Tags | Lidar | Imu

(** A negative shift count shifts in the other direction. A count of 32 or more has the same effect
    as that many shifts by one. Shifting right preserves the sign. *)
and bitwise = Bit_and | Bit_or | Bit_xor | Shift_left | Shift_right

and foreign = {
  module_ : string;
  foreign_name : string;  (** its name in the program *)
  symbol : string;  (** its name in C *)
  kind : foreign_kind;
  span : Basis.Span.t;  (** the span of its declaration *)
}
(** The user's own C code. *)

and foreign_kind =
  | Stateless of int  (** a function with this number of arguments, at least one *)
  | Stateful  (** a signal function *)
