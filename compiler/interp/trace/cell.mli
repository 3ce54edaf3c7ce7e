(** Converts a value to the text of one cell of a trace, and back.

    Numbers have 17 significant digits; in single precision, as few as are needed to read the same
    number back. Special values are [nan], [inf] and [-inf]. When read, a number is rounded to
    double and then to the precision of the program. Bools are [true] and [false]. All other values
    are written as in Frob: [Just 2.5], [At (-0.3)], [Left (1, true)], [Pose {heading = 1}]. An
    event that fills a whole cell is empty when it does not occur, and otherwise its value. An image
    is written as [Image NUMBER SIZE HASH], which identifies its file ([frob/frame.h]). *)

val write : Shape.t -> Value.t -> string
(** Expects a completely evaluated value. Does not quote the text for CSV. *)

val read : ?frames:Kernels.frames -> Shape.t -> string -> (Value.t, string) result
(** On failure, returns what was expected instead. [frames] finds the images. *)

val overflows : string -> bool
(** Whether the text is a number in digits that would be rounded to infinity, as [1e400] would. *)

val largest : Basis.Real.t -> string
(** What is expected in place of such a number. *)
