(** Static bounds on the memory and time that a program needs. *)

type t = {
  program : Step.Ir.program;
  state : State.t;
  operations : Operations.t;
  stack : Stack.bounds;
  machines : Hops.machine list;
}

val of_program : Step.Ir.program -> t

val place : file:string -> Basis.Span.t -> string
(** The source location as the report prints it: without folders, so that the text does not depend
    on where the program and the library are stored. *)

val operations : (string * Cost.kind) list
(** The kinds of operations and their names, in the order of the report. Calls of elementary
    functions are not included. *)

val library : t -> string list
(** The elementary functions that the program calls, sorted. *)
