(** The texts of a program's labels, each once.

    They are constructors of a data type, called as the language writes them: ["goal"]. *)

type t

val create : unit -> t

val number : t -> string -> int
(** Which constructor the text is. *)

val all : t -> string list
(** The names of the constructors; at least one. *)
