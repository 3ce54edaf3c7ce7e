(** Where the texts of modules come from: a directory tree, or, for tests and editors, a table in
    memory. *)

type error = Missing | Unreadable of string  (** the reason *)

type t = {
  read : string -> (string, error) result;  (** by path *)
  modules_in : string -> string list;
      (** names [M] of the files [M.frob] in a directory, in alphabetical order; none if it cannot
          be read *)
  parsed : file:string -> string -> Syntax.Ir.program option;
      (** what {!Syntax.Parse.program} would make of a text, if that is known already; [file] is the
          name that diagnostics show *)
}

val on_disk : t
(** Knows no parsed text. *)

val in_memory : (string * string) list -> t
(** Paths and texts. Knows no parsed text. *)
