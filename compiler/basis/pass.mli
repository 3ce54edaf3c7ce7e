(** Compiler passes over a program, as rows of a table. *)

type 'program t = {
  name : string;
  program : 'program -> 'program;
  reason : string;  (** why the pass is at this place in the table *)
}

val make : string -> ('program -> 'program) -> string -> 'program t

val run : ('program t -> 'program -> unit) -> 'program -> 'program t -> 'program
(** Applies the pass, calls the function with the pass and the new program, and returns the new
    program. *)
