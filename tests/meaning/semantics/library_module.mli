(** What the text of a module of the library declares, if all of it is exported and every value has
    a signature. *)

type t = {
  types : string list;  (** types, constructors and units *)
  values : (string * string) list;  (** names without parentheses, and their types *)
}

val declared : string -> t
