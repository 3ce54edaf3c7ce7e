(** The files that a C compiler has included.

    The scanner in {!Own_headers} reads a file as text, so it lacks some of a C compiler's
    information: which conditions are true, which macro an [#include] names, and in which folder a
    name is found first. So [frobc] also asks the compiler, with the option [-H] of gcc and clang,
    and checks the answer before it runs anything that was compiled. *)

val option : string
(** Makes the compiler list the included files on standard error. *)

val in_folder : string -> string
(** The spelling of the folder's path to pass to the compiler, so that {!check} recognizes the files
    found in that folder. *)

val lists_some : string -> bool
(** Whether the compiler's output lists at least one file. Each program that [frobc] generates
    includes its own header, and each copy of a user's file includes an empty header. So if the
    output lists no file, the compiler ignores {!option}. *)

val identity : string -> (int * int) option
(** The device and inode of a file, or [None] if it cannot be read. Compare these instead of paths,
    because links and other spellings may name the same file. *)

val other_lines : string -> string
(** The compiler's output without the list of included files. *)

val check :
  allowed:string list ->
  sources:string list ->
  folders:string list ->
  string ->
  (unit, string) result
(** Checks the compiler's output: each file that was found in one of [folders] must be [allowed], or
    be in the folder of an allowed file that includes it, or of one of [sources]. *)
