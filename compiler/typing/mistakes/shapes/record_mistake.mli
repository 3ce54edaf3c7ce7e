(** What is said of records where their parts belong, and the other way round. Each is a hint. *)

val built : Show.words -> Expected.t -> string option
(** How a record is built that is wanted here. *)

val parts : Show.words -> subject:Resolve.Ir.expr option -> record:string -> Type.t -> string
(** What there is in a record, or a vector, where a number is needed; [record] is how the subject is
    written. *)

val elements : Show.words -> wanted:Type.t -> Type.t -> string option
(** Of arrays: the elements of the second are records with parts, where the first has numbers or
    truths. *)
