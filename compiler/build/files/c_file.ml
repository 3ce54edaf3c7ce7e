let plain c = if c < ' ' || c = '\127' || c = '"' || c = '\\' then '_' else c

(* A test file's C files are named after its program, because the user's C includes the program's
   header. *)
let name file =
  let program = Resolve.Test_file.program_or_self file in
  String.map plain (Filename.remove_extension (Filename.basename program))

(* Headers that generated C and [<frob/step.h>] include, and headers that these include in some C
   libraries. *)
let needed = [ "features"; "float"; "math"; "stdbool"; "stddef"; "stdint"; "string"; "strings" ]

(* Other headers of C and POSIX that the user's C may include. *)
let standard =
  [
    "assert";
    "complex";
    "ctype";
    "dirent";
    "errno";
    "fcntl";
    "fenv";
    "inttypes";
    "iso646";
    "limits";
    "locale";
    "poll";
    "pthread";
    "sched";
    "setjmp";
    "signal";
    "stdalign";
    "stdarg";
    "stdatomic";
    "stdio";
    "stdlib";
    "stdnoreturn";
    "tgmath";
    "threads";
    "time";
    "uchar";
    "unistd";
    "wchar";
    "wctype";
  ]

let is_standard_header name =
  Filename.check_suffix name ".h" && List.mem (Filename.chop_suffix name ".h") (needed @ standard)

(* Maximum length of a name. Together with the longest suffix, [_driver.c], it stays within the 255
   bytes that file systems allow. *)
let longest = 240

let check ?(beside_c = false) file =
  let name = name file in
  let headers = if beside_c then needed @ standard else needed in
  (* On some systems, file names are not case-sensitive. *)
  if List.mem (String.lowercase_ascii name) headers then
    Error
      (Printf.sprintf "a C program named %s would hide the standard header <%s.h>: rename %s" name
         (String.lowercase_ascii name) file)
  else if String.length name > longest then
    Error
      (Printf.sprintf "the name of %s is too long for C files: use at most %d characters" file
         longest)
  else Ok ()
