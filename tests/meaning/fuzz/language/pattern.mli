(** Random patterns, with the variables that they bind. *)

type bound = string * (string * Type.t) list

val any : Scope.t -> Type.t -> bound
(** One that always matches. *)

val cover : Scope.t -> int -> Type.t -> bound list
(** Some that match together, looking no deeper than the number says. *)
