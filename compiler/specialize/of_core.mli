(** From Core to Flow: runs everything that is static.

    A symbolic evaluator. What is known while compiling (functions, signal functions, types) is
    simply evaluated; an operation on numbers becomes an equation of the node under construction; a
    call of a function with a first-order result, and a run of a signal function, become an instance
    of a node made for that code and the functions it gets (see {!Skeleton}). Core without recursion
    always comes to an end.

    After it no functions, signal functions, tuples and records are left. *)

open Basis

val controls :
  Context.options ->
  Diagnostic.sink ->
  name:string ->
  entry:Core.Ir.Global.t ->
  Core.Ir.program ->
  Core.Ir.control list option
(** What the entry asks of its operator, for {!Core.Console.declare}: found out by running all that
    is static, if the program asks for anything. What it asks for in several places is there as
    often, and without units. [None] if errors were reported. *)

val program :
  ?options:Context.options ->
  ?default:(Core.Ir.param -> Flow.Ir.atom) ->
  Diagnostic.sink ->
  name:string ->
  entry:Core.Ir.Global.t ->
  Core.Ir.program ->
  Flow.Ir.program option
(** [name]: of the C files; [default]: the value of a parameter where none is given. The entry is a
    signal function or program, and closed; [None] if errors were reported. *)
