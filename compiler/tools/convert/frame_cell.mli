(** References from a recording to camera frames. Each frame is a file in a folder next to the
    recording ([runtime/hosts/common/frames.h]). *)

type t = {
  file : string;  (** file name without [.ppm] or [.pgm] *)
  age : int;  (** age of the image when the program received it, in ns *)
}

val all : string -> t list
(** The frames in a cell, such as
    [Frame {image = Image 12 230583 0x6c62272e07bb0142, age = 0.045, number = 12}]. *)

val folder_of : string -> string
(** The folder [LOG.frames] for a recording [LOG.csv] or [LOG.csv.gz]. *)

val is_name : string -> bool
(** Whether a file in that folder can have this name. *)
