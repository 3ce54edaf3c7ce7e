(** Exports a program as a library for other build tools. *)

val platformio :
  Common_options.t -> entry:string -> sources:string list -> folder:string -> string -> int
(** Writes a library folder for PlatformIO: [library.json]; in [src/], the generated C, the user's
    own C files [sources], and the runtime with its drivers; in [examples/], a folder with the
    program's name and a main program for Arduino boards. Returns the exit status. *)

(** {1 Functions for other exports} *)

val copies_of : string -> string -> ((string * string) list, string) result
(** [copies_of source target]: for each file directly in the folder [source], its path in the folder
    [target] and its contents. *)

val own_files :
  into:string ->
  sources:string list ->
  folders:string list ->
  (string * string) list ->
  ((string * string) list, string) result
(** The user's C files [sources], and the headers that they and the generated files include, with
    their new paths and contents. All of them are in one folder. *)
