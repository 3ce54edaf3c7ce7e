(** The declarations in the text of a library module. Assumes that the module exports everything and
    that every value has a signature. *)

type t = {
  types : string list;  (** types, constructors and units *)
  values : (string * string) list;  (** names without parentheses, and their types *)
}

val declared : string -> t
