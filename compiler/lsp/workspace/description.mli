(** The description of a symbol: its declaration, its type and its doc comment. *)

type t = {
  code : string;  (** Frob source *)
  notes : string list;  (** its level, or the place of its declaration *)
  doc : string option;
}

val of_symbol : View.t -> Index.symbol -> t option

val signature : View.t -> Resolve.Ir.Global.t -> string option
(** The type from its signature, or else the inferred type. *)

val doc : View.t -> Resolve.Ir.Global.t -> string option

val parameters : string -> string list
(** Splits a type at its top-level arrows; the result type comes last. *)

val level : Place_types.level -> string
