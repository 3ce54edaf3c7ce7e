(** The disturbances in a world file: noise, slip, drift and losses, each identified by a table and
    a key. Only settings of the form [key = number] below [[table]] are recognized. *)

type t = { table : string; key : string }

val of_world : string -> t list
(** The nonzero disturbances in the text of a world file. *)

val names_files : string -> bool
(** Whether the text refers to pictures. Their paths are relative to the world file. *)

val without : t list -> string -> string
(** Comments out the lines that set these disturbances. *)

val name : t -> string
(** The disturbance in a readable form, such as [[sonar] noise]. *)

val needed : still_fails:(t list -> bool) -> t list -> t list
(** The disturbances that are needed to reproduce a failure. If the run still fails without any
    disturbance, the list is empty. Otherwise, the function removes one disturbance at a time, and
    restores it if the run no longer fails. The argument of [still_fails] is the list of removed
    disturbances. *)
