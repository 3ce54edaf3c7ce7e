let plain c = if c < ' ' || c = '\127' || c = '"' || c = '\\' then '_' else c
let name file = String.map plain (Filename.remove_extension (Filename.basename file))

(* What generated C and [<frob/step.h>] include, and what C libraries include for that. *)
let needed = [ "features"; "float"; "math"; "stdbool"; "stddef"; "stdint"; "string"; "strings" ]

(* What else the user's C may include, of C and POSIX. *)
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

(* With the longest of what follows it, [_driver.c], within the 255 of a file system. *)
let longest = 240

let check ?(beside_c = false) file =
  let name = name file in
  let headers = if beside_c then needed @ standard else needed in
  (* There are systems where names that differ in case only are of one file. *)
  if List.mem (String.lowercase_ascii name) headers then
    Error
      (Printf.sprintf
         "a program in C named %s would hide C's own header <%s.h>: give %s another name" name
         (String.lowercase_ascii name) file)
  else if String.length name > longest then
    Error
      (Printf.sprintf "the name of %s is too long for C files: %d characters at most" file longest)
  else Ok ()
