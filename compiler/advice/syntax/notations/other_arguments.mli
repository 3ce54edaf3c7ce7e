(** Frob equivalents of arguments and arrays in Python and MATLAB notation. *)

val without_keywords : string -> int -> string option
(** [f 1 2] for [f(x=1, y=2)], whose parenthesis opens at this offset. *)

val matrix : string -> int -> string option
(** [[[1, 2], [3, 4]]] for [[1, 2; 3, 4]], whose bracket opens at this offset. *)
