(** From state, reset and step to C: names, structs, and the order of the two files. The root's
    functions are the program's; every other node has its own, static ones. *)

type t = {
  name : string;  (** as C has it *)
  header : Ir.file;
  source : Ir.file;
  input : Interface.t;
  output : Interface.t;
  params : Param_struct.t option;
  sums : Sum_type.t array;
  machines : Machine_table.t list;
}

val program : ?own:Robot.t -> ?batch:bool -> Step.Ir.program -> t
(** [batch]: with {!Batch} too; without unless said. *)
