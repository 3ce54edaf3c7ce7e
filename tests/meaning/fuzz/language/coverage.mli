(** How often each construct of the language stands in random programs. *)

type t

val create : unit -> t

val note : t -> string -> unit
(** One that cannot be told by a word, such as ["recursion through a switch"]. *)

val count_words : t -> string -> unit
(** Of a program's text: the names of the prelude, keywords and operators. *)

val add : t -> t -> unit
(** To the first. *)

val missing : prelude:string -> t -> string list
(** What is never there: of the names in the text of the prelude, of the keywords and of what is
    noted. *)

val text : prelude:string -> t -> string
(** All counts, in lines. *)
