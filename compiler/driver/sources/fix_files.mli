(** [frobc fix]: the fixes that diagnostics come with, made in the file. *)

open Basis

val applied : Source.t -> file:string -> Diagnostic.fix list -> string * Diagnostic.fix list
(** The file's text with as many of the fixes as can be made at once, in their order; and these. One
    that would change other files, or what another has changed, is left. *)

type choice = Safe | All

val run : General.t -> diff:bool -> choice -> string list -> int
(** Makes them, looks at the program again, and so on while there are some, and writes the files;
    with [diff] it shows what would change and writes nothing. What is left to do by hand is printed
    as [frobc check] does. Gives the exit status of what is left. *)
