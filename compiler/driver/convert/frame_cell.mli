(** Frames of cameras as a recording names them: a file each, in a folder beside it
    ([runtime/hosts/common/frames.h]). *)

type t = {
  file : string;  (** without [.ppm] or [.pgm] *)
  age : int;  (** when it was given to the program, in ns *)
}

val all : string -> t list
(** Those in a cell, such as
    [Frame {image = Image 12 230583 0x6c62272e07bb0142, age = 0.045, number = 12}]. *)

val folder_of : string -> string
(** Of [LOG.csv], or [LOG.csv.gz], it is [LOG.frames]. *)

val is_name : string -> bool
(** Of such a file. *)
