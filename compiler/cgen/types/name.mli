(** Derives C names from the names in the source.

    Names that C allows are kept. A prime becomes [_prime], and any other character that an
    identifier cannot contain becomes an underscore. A scope returns each name only once. If a name
    is taken, or has a meaning in C, C++ or their headers, a number is appended. *)

type scope

(** The kind of names in a scope. Members of a struct, unlike other identifiers, may have the names
    of C library functions. *)
type kind = Identifiers | Members

val scope : ?within:scope -> ?taken:string list -> kind -> scope
(** A scope in which the names of the enclosing scopes are taken, too. *)

val fresh : scope -> string -> string
(** A new name for something that has this name in the source. For [""], returns names like [t1]. *)

val identifier : string -> string
(** Converts a name to a C identifier, which {!fresh} then makes unique. *)

val snake : string -> string
(** Converts the name of a type: [Maybe Float] becomes [maybe_float], [PioneerInput] becomes
    [pioneer_input]. *)

val short : string -> string
(** Shortens a type's name to the words that fit into 48 characters, because nested types have long
    names. Different names may become equal; {!fresh} numbers them. *)
