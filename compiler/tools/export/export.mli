(** Exports a program as a library for other build tools. *)

val platformio :
  Common_options.t -> entry:string -> sources:string list -> folder:string -> string -> int
(** Writes a library folder for PlatformIO: [library.json]; in [src/], the generated C, the user's
    own C files [sources], and the runtime with its drivers; in [examples/], a folder with the
    program's name and a main program for Arduino boards. Returns the exit status. *)
