(** Random constants, and the syntax of values. *)

val odd_float : Scope.t -> string
(** NaN, an infinity, a negative zero, or a number near the end of the range. *)

val literal : Scope.t -> Type.t -> string
(** A constant of this type, as text that can be used anywhere. *)

val annotated : string -> Type.t -> string
(** The text [(text :: type)]. *)

val construct : Type.data -> Type.constructor -> string list -> string
(** An application of a constructor to these arguments; also used for patterns. *)

val array : string list -> string

val in_range : Basis.Real.t -> string -> string
(** Adapts the literals in a program's text to this precision. *)
