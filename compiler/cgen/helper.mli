(** The functions that generated code brings along, each only where needed:
    integers that wrap around, division that is total, conversions that
    saturate, minimum and maximum that let a NaN through, time in whole
    nanoseconds. See the language reference, section 4, "Numbers are total".

    Literal limits have helpers of their own, because then one comparison, one
    machine instruction, is enough. *)

type t =
  | Wrap  (** [uint32_t] to [int32_t] *)
  | Int_add
  | Int_subtract
  | Int_multiply
  | Int_negate
  | Int_absolute
  | Int_signum
  | Int_minimum
  | Int_maximum
  | Int_div
  | Int_mod
  | Bit_and
  | Bit_or
  | Bit_xor
  | Shift_left
  | Shift_right
  | Float_add  (** of a literal zero *)
  | Float_subtract  (** likewise *)
  | Float_minimum
  | Float_maximum
  | Least  (** a number rather than NaN, unlike [Float_minimum] *)
  | Largest
  | At_most  (** the minimum of a value and a limit that is not NaN *)
  | At_least
  | Where  (** a number or 0.0 *)
  | Limit  (** [max (-x) (min x y)] *)
  | Float_signum
  | Truncate
  | Floor
  | Ceiling
  | Round
  | Whole_nanoseconds  (** of a dt in seconds *)
  | Dt_nanoseconds  (** of a dt in seconds, in a mode: see {!Machine.Time_use.rounded_by_modes} *)
  | Whole_dt  (** of a dt in seconds, in seconds too; calls [memcpy] *)
  | Seconds  (** of a dt in whole nanoseconds *)
  | Time_in_nanoseconds  (** of a local time *)
  | Time_span  (** nanoseconds within bounds; in single precision only *)
  | Later
  | Soon  (** where [Later] would not saturate *)
  | Reached
  | Rest
  | Branch  (** the condition of an [if] that is to stay one *)
  | Restrict  (** a macro: nothing else leads to what a pointer leads to *)
  | Shared  (** a macro: this function is to stay one (see {!Shared}) *)
  | One_copy  (** a macro: likewise where size counts, else one is worth a copy at each call *)

val name : t -> string
val names : string list

val text : real:Basis.Real.t -> (t -> bool) -> string list
(** The C text, in the precision of the program, of those wanted and of what they need themselves, in an order
    that compiles. *)
