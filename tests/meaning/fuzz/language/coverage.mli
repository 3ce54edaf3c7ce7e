(** Counts how often each construct of the language occurs in random programs. *)

type t

val create : unit -> t

val note : t -> string -> unit
(** Counts a construct that no single word shows, such as ["recursion through a switch"]. *)

val count_words : t -> string -> unit
(** Counts the words of a program's text: names of the prelude, keywords and operators. *)

val add : t -> t -> unit
(** Adds the second counts to the first. *)

val missing : prelude:string -> t -> string list
(** The constructs that never occur, among the names in the prelude's text, the keywords, and the
    constructs that {!note} counts. *)

val text : prelude:string -> t -> string
(** All counts, one a line. *)
