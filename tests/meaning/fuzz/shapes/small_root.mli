(** Programs as small as the first that one writes: a few numbers which are kept from one instant to
    the next, and some of which begin in their own way. *)

val make : Scope.t -> pattern:string * (string * Type.t) list -> string * Type.t list
(** A [proc] of an input with that pattern, which gives a tuple, and what is in it. *)
