(** The distinct label texts of a program.

    They become the constructors of a data type, each named after its string literal, such as
    ["goal"]. *)

type t

val create : unit -> t

val number : t -> string -> int
(** The index of the constructor for this text. *)

val all : t -> string list
(** The names of the constructors; at least one. *)
