(** Names that users bring along from Haskell, Yampa, C, Python, MATLAB and the libraries of boards,
    and that Frob has by another name, or not.

    Words that a robot's program may well have as names of its own, such as [range] and [error], are
    left out: a misspelt one of these is more likely. *)

val value : string -> string option
(** A hint for who writes this name of a value, unless Frob has one just like it. *)

val robot : string -> string option
(** Likewise of what a robot senses and does, where the program has nothing of a like name. *)

val is_statement : string -> bool
(** Is that the word of a statement, so that what follows is of that language too? *)

val constructor : string -> string option
(** Likewise of a constructor, as in an expression or a pattern. *)

val type_ : string -> string option
(** Likewise of a type. *)

val class_ : string -> string option
(** Likewise of a type class. *)

val module_ : string -> string option
(** Likewise of a module, as in [Math.sqrt]. *)
