(** Random tasks. *)

val task : Reactive.maker -> slow:bool -> int -> Type.t -> Type.t -> Type.t -> string
(** [task m ~slow fuel a b c] has type [Task a b c]. If [slow], it does not end at its first
    instant, so that it can be repeated. *)

val any_result : Reactive.maker -> Type.t
(** A result type for tasks. *)

val alternatives : Reactive.maker -> int -> Type.t -> Type.t -> (int * (unit -> string)) list
(** Signal functions made from tasks, in the form of {!Reactive.alternatives}. *)
