(** From a file to Flow as it was written: all that can reject a program, whatever is to run it.
    {!Pipeline} goes on from there. *)

open Basis

type t = {
  typed : Typing.Ir.program;
  written : Typing.Ir.definition;  (** the entry, as the programmer knows it *)
  closed : Core.Ir.program * Core.Ir.Global.t;  (** the program for its robot, and its entry *)
  flow : Flow.Ir.program;
  margin : Basis.Span.t -> Core.Formula.t option;  (** of each assertion, by its place *)
}

val program : Diagnostic.sink -> Source.t -> Request.t -> t option

(** What is known on the way, whatever comes to be wrong later. *)
type tree =
  | Resolved of Resolve.Ir.program  (** all of the library's modules in it *)
  | Typed of Typing.Ir.program

val check : ?seen:(tree -> unit) -> Diagnostic.sink -> Source.t -> Request.t -> unit
(** The same for the module's [main] or, where there is none, for each signal function that could be
    an entry. Each tree is [seen] as soon as it is there. *)

val partial : Source.t -> Request.t -> (Resolve.Ir.program * Typing.Ir.program Lazy.t) option
(** What can be understood of a program with mistakes, for editors. *)

val params : Diagnostic.sink -> Source.t -> Request.t -> Params.set list option
(** What the request sets parameters to. *)

val units_of_params : Diagnostic.sink -> Source.t -> Request.t -> (string * string) list option
(** Of each parameter of the program, by its label. *)

val checks : Diagnostic.sink -> Source.t -> Request.t -> Checks.t list option
(** The tests and trials in the file's module. *)

val lint : Flow.Ir.program -> unit
(** What is true of Flow between any two stages. *)
