(** Random constants, and values written out. *)

val literal : Scope.t -> Type.t -> string
(** Of a type, as text that can stand anywhere. *)

val annotated : string -> Type.t -> string
(** [(text :: type)] *)

val construct : Type.data -> Type.constructor -> string list -> string
(** With these arguments; also as a pattern. *)

val array : string list -> string

val in_range : Basis.Real.t -> string -> string
(** A program's text, its literals made ones of that precision. *)
