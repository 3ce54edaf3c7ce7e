(** What may be written, decided in one place: never what is read, never the same file twice, never
    a file that frobc did not make, but a program that it is to format. Devices and pipes may be
    written; so may an empty file. *)

type content =
  | C  (** generated C and headers: the first line says so *)
  | Table  (** a trace or a recording: its first column is [time] *)
  | Mcap  (** its header says that we have written it *)
  | Picture  (** PNG, or SVG as frobc draws it *)
  | Rows  (** the table of a sweep: its first columns are [run,world,robot] *)
  | World  (** the first line says so *)
  | Program  (** an executable with a table for hosts *)
  | Link  (** a symbolic link *)
  | Log  (** of a served robot; it goes on where it ended *)
  | Source  (** of a program, which was read and is asked to be written anew *)

type t = {
  path : string;
  content : content;
  asked : string;  (** by what option, for messages: ["--record"] *)
}

val asked : content -> string -> string -> t
(** [asked content option path] *)

val check : reads:string list -> t list -> (unit, string) result
(** Whether all may be written by a command that reads these files; the error says which one not,
    why, and what to do. *)

val write : (string * string) list -> (unit, string) result
(** Paths and texts, all or none: they are written beside, and renamed when all are whole. *)

val stream : string -> (string -> (unit, string) result) -> (unit, string) result
(** [stream path work], for what is too long for the memory: [work] writes a file of the name that
    it is given, and may raise [Sys_error]. *)

val rewrite : string -> string -> (unit, string) result
(** [rewrite path text], likewise, with the permissions that the file has. *)

val copy : string -> string -> (unit, string) result
(** [copy from path], likewise, executable. *)

val folder : string -> (unit, string) result
(** Makes the folder, and those above it, if they are not there. *)
