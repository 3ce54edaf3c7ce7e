(** One value as the text of one cell of a trace.

    Numbers have 17 significant digits, in single precision as few as are read back as the same
    number ([nan], [inf], [-inf]); what is read is rounded to a double and that to the precision of
    the program. Truth values are [true] and [false], everything else stands as Frob would write it:
    [Just 2.5], [At (-0.3)], [Left (1, true)], [Pose {heading = 1}]. An event that is the whole cell
    is empty when it does not occur, else its value. An image is the name of its file
    ([frob/frame.h]). *)

val write : Shape.t -> Value.t -> string
(** Of a wholly evaluated value. Nothing is quoted. *)

val read : ?frames:Kernels.frames -> Shape.t -> string -> (Value.t, string) result
(** The error says what was expected instead. [frames]: where images are. *)
