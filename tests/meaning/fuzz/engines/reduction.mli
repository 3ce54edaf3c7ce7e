(** Makes smaller programs from a program's text. They may be invalid; the caller finds out by
    compiling them.

    Random programs put every expression in parentheses and every equation on a line, so the text
    shows enough structure. *)

val paragraphs : string -> string list
(** The parts of a text between blank lines. *)

val lines : string -> string list

val without_some : separator:string -> string list -> (string -> bool) -> string list
(** [without_some ~separator parts good] removes as many parts as it can find such that the rest is
    still [good] when joined. It first removes large chunks, then smaller ones. All parts together
    must be [good]. *)

val at : string -> int -> (int * string list) option
(** [at text i] is the first place at or after [i] where a part can be replaced, and the whole texts
    with smaller replacements at that place, the smallest first. *)
