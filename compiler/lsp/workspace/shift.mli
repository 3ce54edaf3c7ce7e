(** Maps places in one version of a text to places in another.

    If two versions are consecutive, places before the first difference and after the last
    difference correspond to each other. Places between them have no counterpart. *)

type step
type t = step list

val none : t

val between : string -> string -> t
(** [between from to_] is the shift from one text to another. *)

val and_then : t -> t -> t
(** Composes two shifts. The second must start with the text that the first one ends with. *)

val back : t -> t
(** The inverse shift. *)

val offset : t -> int -> int option
(** Maps an offset in the first text to an offset in the last text. *)

val place : t -> int * int -> (int * int) option
(** Maps a range whose text is unchanged. *)

val range : t -> int * int -> (int * int) option
(** Maps a range whose ends still exist. The text inside may have changed. *)
