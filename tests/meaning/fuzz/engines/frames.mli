(** A few small images, for random programs with cameras.

    They are files in a folder next to a recording, as hosts write them. *)

val write : folder:string -> unit
(** Writes the images that belong to [folder/in.csv]. Call it once for each folder; afterwards
    {!any} returns these images. *)

val any : Random.State.t -> Kernels.image
(** A random image. Call {!write} first. *)
