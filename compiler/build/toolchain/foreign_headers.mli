(** Checks the headers that a program names with [foreign include]. A header is C code, which runs
    with the user's permissions. So a program, or a module that it imports, may only name a header
    that the command line allows: one named with [--with], or included by a file named with
    [--with]. *)

type t = {
  folders : string list;
      (** the search path for includes in quotes: first the folders of the given files, then those
          of modules whose headers are allowed *)
  headers : string list;  (** the paths of the headers that the modules name *)
}

val allowed :
  generated:string list -> sources:string list -> Flow.Ir.header list -> (t, string) result
(** [allowed ~generated ~sources headers] checks the headers. [sources] are the files given with
    [--with]; [generated] are the names of headers that [frobc] writes itself. The error names each
    header that is not allowed, and the option that allows it. Standard headers need no option. *)

val refused : generated:string list -> sources:string list -> Flow.Ir.header list -> string list
(** The paths of the headers that are not allowed. *)
