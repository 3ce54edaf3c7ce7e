(** What a camera shows a random program: frames are events, kernels look at them, and trackers
    follow what is in them.

    Frames are those of {!Frames}; the camera is on the console of [main]. *)

val imports : string

val definition : Random.State.t -> number:int -> input:Type.t -> string * string
(** Name and text of a signal function that makes of the console and the input of the program of
    that number another such input, with what is seen mixed into it. *)
