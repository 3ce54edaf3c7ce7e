(** Random expressions of a given type, as text that can be used anywhere. *)

val expression : Scope.t -> int -> Type.t -> string
(** The number limits the depth. *)

val lambda : Scope.t -> int -> Type.t -> Type.t -> string
(** A function of one argument. *)
