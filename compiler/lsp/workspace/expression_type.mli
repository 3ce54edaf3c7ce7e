(** The type of an expression that the user is entering, taken from the last version without errors.
*)

val of_name : Document.t -> offset:int -> string -> Typing.Ir.ty option
(** The type of the variable or definition to which this name most likely refers at this offset. *)

val fields : Document.t -> Typing.Ir.ty -> (string * Typing.Ir.ty) list
(** The fields of a record type. *)
