(** The files that a C compiler has included.

    The scanner in {!Own_headers} reads a file as text. Unlike a C compiler, it does not know which
    conditions are true, which file a macro in an [#include] names, or in which folder the compiler
    finds a name first. So [frobc] also makes the compiler list the files, with the option [-H] of
    gcc and clang, and checks the list before it runs anything that was compiled. *)

val option : string
(** Makes the compiler list the included files on standard error. *)

val in_folder : string -> string
(** The path to pass to the compiler for this folder, so that {!check} recognizes the files found in
    it. *)

val lists_some : string -> bool
(** Whether the compiler's output lists at least one file. Each program that [frobc] generates
    includes its own header, and each copy of a user's file includes an empty header. So if the
    output lists no files, the compiler ignores {!option}. *)

val identity : string -> (int * int) option
(** The device and inode of a file, or [None] if it cannot be read. Compare these instead of paths,
    because different paths may lead to the same file, for example through links. *)

val other_lines : string -> string
(** The compiler's output without the list of included files. *)

val check :
  allowed:string list ->
  sources:string list ->
  folders:string list ->
  string ->
  (unit, string) result
(** Checks the compiler's output: each file that was found in one of [folders] must be one of
    [allowed], or be in the same folder as one of [sources] or as an allowed file that includes it.
*)
