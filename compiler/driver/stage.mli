(** The stages of the compiler, in order: the one table from which the options [--dump] and
    [--stop-after], their help and the pipeline take the names. *)

type t = Parse | Resolve | Types | Core | Specialize | Passes | Flow | Step | C

val all : t list
val name : t -> string
val of_name : string -> t option

val meaning : t -> string
(** What a dump of the stage shows, in a few words. *)
