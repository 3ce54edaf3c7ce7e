let plain c = if c < ' ' || c = '\127' || c = '"' || c = '\\' then '_' else c
let name file = String.map plain (Filename.remove_extension (Filename.basename file))

(* Of C99 to C23, and of POSIX what C libraries include in those. *)
let headers =
  [
    "alloca"; "assert"; "complex"; "ctype"; "dirent"; "endian"; "errno"; "fcntl"; "features";
    "fenv"; "float"; "inttypes"; "iso646"; "limits"; "locale"; "malloc"; "math"; "poll";
    "pthread"; "sched"; "setjmp"; "signal"; "stdalign"; "stdarg"; "stdatomic"; "stdbit";
    "stdbool"; "stdckdint"; "stddef"; "stdint"; "stdio"; "stdlib"; "stdnoreturn"; "string";
    "strings"; "termios"; "tgmath"; "threads"; "time"; "uchar"; "unistd"; "values"; "wchar";
    "wctype";
  ]

(* With the longest of what follows it, [_driver.c], within the 255 of a file system. *)
let longest = 240

let check file =
  let name = name file in
  (* Where file names differ by more than their letters' case only. *)
  if List.mem (String.lowercase_ascii name) headers then
    Error
      (Printf.sprintf
         "a program in C named %s would hide C's own header <%s.h>: give %s another name" name
         (String.lowercase_ascii name) file)
  else if String.length name > longest then
    Error
      (Printf.sprintf "the name of %s is too long for C files: %d characters at most" file longest)
  else Ok ()
