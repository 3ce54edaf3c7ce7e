(** A few small pictures, for random programs that see.

    They are files in the folder beside a recording, as hosts have them. *)

val write : folder:string -> unit
(** Those of [folder/in.csv]; once for each folder. From then on {!any} has them. *)

val any : Random.State.t -> Kernels.image
(** After {!write}. *)
