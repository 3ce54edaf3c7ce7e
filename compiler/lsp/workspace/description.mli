(** What is to be said of a symbol: its declaration, its type, its doc comment. *)

type t = {
  code : string;  (** as Frob *)
  notes : string list;  (** its level, or where it comes from *)
  doc : string option;
}

val of_symbol : View.t -> Index.symbol -> t option

val signature : View.t -> Resolve.Ir.Global.t -> string option
(** Its type as it was written, or else as it was inferred. *)

val doc : View.t -> Resolve.Ir.Global.t -> string option

val parameters : string -> string list
(** The parts of a type between arrows at its top, the result last. *)

val level : Facts.level -> string
