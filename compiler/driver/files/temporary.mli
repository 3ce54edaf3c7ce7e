(** Folders that are there only as long as this process, and what it hands over to. *)

val folder : unit -> string
(** A fresh folder in [TMPDIR], or [/tmp], that nobody else may look into. It goes when this process
    and those that it has started have ended, however they end. Raises [Unix.Unix_error] where none
    can be made. *)

val remove : string -> unit
(** A file, or a folder with all that is in it; as much of it as can be removed. *)
