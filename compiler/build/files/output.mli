(** Decides in one place which files may be written: never a file that is also read, never the same
    file twice, and never a file that frobc did not create, except a program's source that the
    command rewrites. Devices, pipes and empty files may be written. *)

type content =
  | C  (** generated C and headers, recognized by their first line *)
  | Table  (** a trace or a recording, whose first column is [time] *)
  | Mcap  (** an MCAP file whose header names frobc *)
  | Picture  (** a PNG file, or an SVG file from frobc *)
  | Rows  (** the table of a sweep, whose first columns are [run,world,robot] *)
  | World  (** a world, recognized by its first line *)
  | Program  (** an executable that contains [frob_program], the table for hosts *)
  | Link  (** a symbolic link *)
  | Log  (** a log of [frobc serve], to which new lines are appended *)
  | Source  (** a program's source, which has been read and will be rewritten *)

type t = {
  path : string;
  content : content;
  asked : string;  (** the option that names the file, for messages: ["--record"] *)
}

val asked : content -> string -> string -> t
(** [asked content option path] describes an output that the user requested. *)

val check : reads:string list -> t list -> (unit, string) result
(** Checks that a command that reads the files [reads] may write all of these files. The error names
    the first file that it may not write, the reason, and the fix. *)

val write : (string * string) list -> (unit, string) result
(** Writes texts to paths, all or none: writes temporary files first, and renames them when all are
    complete. *)

val stream : string -> (string -> (unit, string) result) -> (unit, string) result
(** [stream path work] is for outputs that are too large for memory: [work] receives a path and
    writes that file; it may raise [Sys_error]. *)

val rewrite : string -> string -> (unit, string) result
(** [rewrite path text] writes a file and keeps its owner and permissions. If the file has several
    hard links, it is written in place, so that all links keep referring to it. *)

val copy : string -> string -> (unit, string) result
(** [copy from path] copies a file and makes the copy executable. *)

val folder : string -> (unit, string) result
(** Creates the folder and its parents if they do not exist. *)
