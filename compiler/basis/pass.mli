(** Passes over a program, as rows of a table. *)

type 'program t = {
  name : string;
  program : 'program -> 'program;
  reason : string;  (** of its place among the others *)
}

val make : string -> ('program -> 'program) -> string -> 'program t

val run : ('program t -> 'program -> unit) -> 'program -> 'program t -> 'program
(** The program that the pass makes of this one, after which the function is called. *)
