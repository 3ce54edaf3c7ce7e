(** The stages of the compiler, in order. The options [--dump] and [--stop-after], their help texts
    and the pipeline take the names from this table. *)

type t = Parse | Resolve | Types | Core | Specialize | Passes | Flow | Step | C

val all : t list
val name : t -> string
val of_name : string -> t option

val meaning : t -> string
(** A short description of what a dump of the stage shows. *)
