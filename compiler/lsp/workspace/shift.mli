(** Maps places in one version of a text to another version.

    For two consecutive versions, the text before the first difference and after the last difference
    has corresponding places. The text between them has no corresponding places. *)

type step
type t = step list

val none : t

val between : string -> string -> t
(** [between from to_] is the shift from one text to another. *)

val and_then : t -> t -> t
(** Composes two shifts. The second must start with the text with which the first ends. *)

val back : t -> t
(** The inverse shift. *)

val offset : t -> int -> int option
(** Maps an offset in the first text to the last text. *)

val place : t -> int * int -> (int * int) option
(** Maps a range whose text is unchanged. *)

val range : t -> int * int -> (int * int) option
(** Maps a range whose ends still exist; the text inside may have changed. *)
