(** What the text of the prelude declares. All of it is exported, and every value
    has a signature. *)

type t = {
  types : string list;  (** types, constructors and units *)
  values : (string * string) list;  (** names without parentheses, and their types *)
}

val declared : string -> t
