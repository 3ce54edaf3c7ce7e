(** Source of module texts: a directory tree, or, for tests and editors, a table in memory. *)

type error = Missing | Unreadable of string  (** the reason *)

type t = {
  read : string -> (string, error) result;  (** reads the file at a path *)
  modules_in : string -> string list;
      (** the names [M] of the files [M.frob] in a directory, without test files, in alphabetical
          order; empty if the directory cannot be read *)
  parsed : file:string -> string -> Syntax.Ir.program option;
      (** the cached result of {!Syntax.Parse.program} for a text, if there is one; [file] is the
          name shown in diagnostics *)
}

val on_disk : t
(** Files on disk, without cached results. *)

val in_memory : (string * string) list -> t
(** Files in memory, given as pairs of a path and a text, without cached results. *)
