(** Names of the C code, made from those of the source.

    A name stays as it is where C allows it; a prime becomes [_prime], what else an identifier
    cannot hold becomes an underscore. A scope hands out each name once, so different things of one
    scope never share a name: where two would, or where a name means something in C, C++ or their
    headers, a number follows it. *)

type scope

(** Members of a struct may be called as functions of the C library are. *)
type kind = Identifiers | Members

val scope : ?within:scope -> ?taken:string list -> kind -> scope
(** A scope in which the names of the scopes around it are taken too. *)

val fresh : scope -> string -> string
(** A name for a thing that the programmer calls so; [""] makes a name like [t1]. *)

val identifier : string -> string
(** The name with which {!fresh} starts. *)

val snake : string -> string
(** For types: [Maybe Float] becomes [maybe_float], [PioneerInput] [pioneer_input]. *)

val short : string -> string
(** The words of a type's name that fit in 48 characters: types are nested, and so are their names.
    Different names may become one; {!fresh} numbers them. *)
