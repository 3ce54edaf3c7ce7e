(** Code that belongs to a signal function, and not to a task inside it. *)

open Basis

val is_certain : Wording.t -> Span.t -> bool
(** Is the code part of a definition of the form [f = proc x -> …], with no task around the code?
    Reads the definition up to the code. Returns false if in doubt. *)

val no_tasks : string option -> string
(** The hint for a task with this source text. *)
