(** A program as a library for other build tools. *)

val platformio : General.t -> entry:string -> sources:string list -> folder:string -> string -> int
(** Writes a library folder for PlatformIO: [library.json]; in [src/] the generated C, the user's
    own C files [sources], and the runtime with its drivers; in a folder of [examples/] with the
    program's name a main program for boards with the Arduino framework. The exit status. *)
