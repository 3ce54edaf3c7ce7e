(** The type of something that is just being written, as the last version without mistakes has it.
*)

val of_name : Document.t -> offset:int -> string -> Typing.Ir.ty option
(** Of the variable or definition that this name most likely means at this offset. *)

val fields : Document.t -> Typing.Ir.ty -> (string * Typing.Ir.ty) list
(** Of a record type. *)
