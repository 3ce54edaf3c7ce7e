(** Reports definitions that restart themselves at ever larger types.

    A definition with a signature may use itself at types other than its own. Through the
    continuations of switches, that would create a mode for each of infinitely many types. *)

val facts : Uses.t -> Fact.t list
(** Reports each such use. Takes linear time. *)
