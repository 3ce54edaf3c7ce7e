(** Machines in a circle: one of a machine's inputs is made of what the machine gives at the same
    instant, and shows an instant later only.

    Such a machine cannot be opened, as another node can that feeds back to itself, so it is stepped
    on trial first, without that input. *)

val machine : Reactive.maker -> Type.t -> late:Type.t -> Type.t -> string
(** [machine m a ~late b], of type [SF (a, late) b]. *)
