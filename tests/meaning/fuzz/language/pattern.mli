(** Random patterns, with the variables that they bind. *)

type bound = string * (string * Type.t) list

val any : Scope.t -> Type.t -> bound
(** A pattern that always matches. *)

val cover : Scope.t -> int -> Type.t -> bound list
(** Patterns that together always match. The number limits their depth. *)
