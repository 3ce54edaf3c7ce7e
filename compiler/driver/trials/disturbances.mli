(** What disturbs a robot in a world file: noise, slip, drift, and what is lost; as keys of the
    file's tables. What is written in other ways than [key = number] below [[table]] is not found.
*)

type t = { table : string; key : string }

val of_world : string -> t list
(** In the text of a world file, in its order: those that are not zero. *)

val names_files : string -> bool
(** Pictures, which are found from the folder of the world file. *)

val without : t list -> string -> string
(** The text without these: their lines become comments. *)

val name : t -> string
(** [[sonar] noise] *)

val needed : still_fails:(t list -> bool) -> t list -> t list
(** Those without which it does not fail any more: takes away all, if it fails so, and else one
    after the other, as long as it does. [still_fails] is told which are left out. *)
