(** The topics of a ROS 2 node: the fields of the records that it reads and returns.

    Reports [E0509] for a field that is not a topic. *)

open Basis

val of_program :
  Diagnostic.sink ->
  resolved:Resolve.Ir.program ->
  Typing.Ir.program ->
  Typing.Ir.definition ->
  rate:float ->
  Cgen.Node_table.t option
(** The topics of the entry, which is a node. [None] after an error. *)
