(** Translates Core to Flow by evaluating everything static.

    This is a symbolic evaluator. Values known at compile time (functions, signal functions, types)
    are simply evaluated. An operation on numbers becomes an equation of the node under
    construction. A call of a function with a first-order result, or a run of a signal function,
    becomes an instance of a node created for that code and its function arguments (see
    {!Specialization_key}). Without recursion, evaluating Core always terminates.

    The result contains no functions, signal functions, tuples or records. *)

open Basis

val controls :
  Context.options ->
  Fact.t Facts.t ->
  name:string ->
  entry:Core.Ir.Global.t ->
  Core.Ir.program ->
  Core.Ir.control list option
(** The controls that the entry requests from its operator, for {!Core.Console.declare}. If the
    program may request controls, finds them by evaluating everything static. A control that is
    requested at several places occurs several times in the result. The units of the controls are
    not set. [None] if errors were reported. *)

val program :
  ?options:Context.options ->
  ?default:(Core.Ir.param -> Flow.Ir.atom) ->
  Fact.t Facts.t ->
  name:string ->
  entry:Core.Ir.Global.t ->
  Core.Ir.program ->
  Flow.Ir.program option
(** [name]: the name of the generated C files. [default]: the value of a parameter that is not set.
    The entry must be a closed signal function or program. [None] if facts were reported. *)
