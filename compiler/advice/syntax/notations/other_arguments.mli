(** Frob equivalents of arguments and arrays in Python and MATLAB notation. *)

val without_keywords : string -> int -> string option
(** [f 1 2] for [f(x=1, y=2)], where this offset is that of the parenthesis. *)

val matrix : string -> int -> string option
(** [[[1, 2], [3, 4]]] for [[1, 2; 3, 4]], where this offset is that of the bracket. *)
