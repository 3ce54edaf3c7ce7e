(** The one table of what the language has built in.

    A primitive is declared with its type in the standard library
    ([primitive sin :: Float -> Float]) and has its row here; its meaning is given by {!Specialize}
    (and by the interpreter). *)

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
  | Power_literal of int  (** [e ^ k]; not declared: the syntax makes it *)
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
  (* structural, on any data without functions *)
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
  | Map_sf  (** one for each element of an array *)
  | Parallel  (** [parZ] *)
  | Initially
  | On_event
  (* tasks *)
  | Make_task
  | Until_right
  | Return
  | Sequence  (** [do]: a task, and the function that gives the task after it *)
  | Run_task
  (* programs *)
  | Reactimate  (** [SF i o -> Program i o] *)
  | Ending  (** tells the host of the program when it has ended, and with what *)
  (* what stands on an operator's console, by its label; see {!Console} *)
  | Console of console
  (* drawings, as the library's module Display has them *)
  | Text_of
  | Blank
  | Drawn
  | Together
  (* declared by programs *)
  | Foreign of foreign  (** in C *)

(** The runtime's elementary functions ([frob/elementary.h]), and those that IEEE 754 defines to the
    last bit: [Sqrt], the whole number next below or above, as a Float (C's [floor] and [ceil]), and
    whole nanoseconds. *)
and elementary =
  | Sqrt
  | Floor_float
  | Ceiling_float
  | Nanoseconds
      (** of seconds, of the precision of Float: 10⁹ times as many, rounded to a whole number,
          halves to even; of negative ones 0, of NaN NaN *)
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

(** What it takes: a label, but for [Map], of which there is one; the limits and the first position
    of a knob, the first of a toggle; and the console. *)
and console = Button | Hold | Knob | Toggle | Map | Camera | Tags

(** A shift by a negative number goes the other way; one by 32 or more is what as many by one are.
    To the right the sign stays. *)
and bitwise = Bit_and | Bit_or | Bit_xor | Shift_left | Shift_right

and foreign = {
  module_ : string;
  foreign_name : string;  (** in the program *)
  symbol : string;  (** in C *)
  kind : foreign_kind;
  span : Basis.Span.t;  (** of its declaration *)
}
(** C code of the user's. *)

and foreign_kind =
  | Stateless of int  (** a function of so many arguments, at least one *)
  | Stateful  (** a signal function *)

val of_name : string -> t option
(** By the name in the library's declaration. *)

val name : t -> string

val key : t -> string
(** Different for different primitives: one in C may have the name of any. *)

val arity : t -> int
