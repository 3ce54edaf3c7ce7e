(** Operators that a program tries to define, such as [<+>]. *)

open Basis

val defined : string -> int -> (string * int) option
(** The operator at this offset of a text, with the offset of its first character, if the text
    defines it in a signature or in an equation. *)

val advice : string -> string -> string
(** [advice text operator] says to define a function instead, with the equation that the text
    contains. *)

val is_in_an_instance : text:string -> Span.t -> bool

val built_in_class : text:string -> Span.t -> (string * Span.t) option
(** If this place is in an instance of [Eq] or [Ord]: the class, and the place of the instance's
    head. *)
