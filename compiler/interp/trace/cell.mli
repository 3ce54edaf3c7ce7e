(** Converts a value to the text of one cell of a trace, and back.

    Numbers have 17 significant digits; in single precision, they have the fewest digits from which
    the same number is read back. Special values are [nan], [inf] and [-inf]. When read, a number is
    rounded to double and then to the precision of the program. Bools are [true] and [false]. All
    other values are written as in Frob: [Just 2.5], [At (-0.3)], [Left (1, true)],
    [Pose {heading = 1}]. If the whole cell is one event, it contains just the event's value, or is
    empty if the event does not occur. An image is written as [Image NUMBER SIZE HASH], which
    identifies its file ([frob/frame.h]). *)

val write : Shape.t -> Value.t -> string
(** Converts a completely evaluated value to text. Does not quote the text for CSV. *)

val read : ?frames:Kernels.frames -> Shape.t -> string -> (Value.t, string) result
(** Reads a value of this shape. On failure, returns a description of the expected text. Images are
    loaded from [frames]. *)

val overflows : string -> bool
(** Whether the text is a number that would be rounded to infinity, such as [1e400]. *)

val largest : Basis.Real.t -> string
(** The range of numbers, as stated in the error message for a number that {!overflows}. *)
