(** Programs as small as a beginner's first ones: a few numbers that are remembered from one instant
    to the next, some of which start in a special way. *)

val make : Scope.t -> pattern:string * (string * Type.t) list -> string * Type.t list
(** A [proc] for an input with this pattern, whose output is a tuple; also returns the types of the
    components. *)
