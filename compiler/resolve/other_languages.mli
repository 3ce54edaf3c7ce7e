(** Names that users bring along from Haskell, Yampa, C and Python, and that Frob has by
    another name, or not. *)

val value : string -> string option
(** A hint for who writes this name of a value, unless Frob has one just like it. *)

val constructor : string -> string option
(** Likewise of a constructor, as in an expression or a pattern. *)
