(** Random programs with a camera: frames are events, kernels analyse them, and trackers follow
    objects in them.

    The frames are those of {!Frames}; the camera is on the console of [main]. *)

val imports : string

val definition : Random.State.t -> number:int -> input:Type.t -> string * string
(** Name and text of a signal function that takes the console and the input of the program with this
    number, and mixes results from the camera into the input. *)
