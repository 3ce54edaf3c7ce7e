(** Machines in a loop: one input of a machine depends on the machine's output at the same instant,
    but affects it only an instant later.

    The compiler can inline other nodes that feed back to themselves, but not such a machine. So the
    generated C first steps it on trial, without that input. *)

val machine : Reactive.maker -> Type.t -> late:Type.t -> Type.t -> string
(** [machine m a ~late b] has type [SF (a, late) b]. *)
