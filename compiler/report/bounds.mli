(** What can be said of a program before it runs. *)

type t = {
  program : Step.Ir.program;
  state : State.t;
  operations : Operations.t;
  stack : Stack.bounds;
  machines : Hops.machine list;
}

val of_program : Step.Ir.program -> t

val place : file:string -> Basis.Span.t -> string
(** As the report names it: without folders, so that it reads the same wherever the program and the
    library are. *)

val operations : (string * Cost.kind) list
(** The kinds of operations in the order of the report, by name; without the calls of the elementary
    functions. *)

val library : t -> string list
(** The elementary functions that are called, sorted. *)
