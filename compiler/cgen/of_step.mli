(** Translates Step to C: chooses the names and the structs, and composes the header and the source
    file. The functions of the root are external and have the program's name; those of all other
    nodes are static. *)

type t = {
  name : string;  (** name in C *)
  header : Ir.file;
  source : Ir.file;
  input : Interface.t;
  output : Interface.t;
  params : Param_struct.t option;
  sums : Sum_type.t array;
  machines : Machine_table.t list;
  is_valid : string option;  (** the function of {!Validity}, if there is one *)
}

val program :
  ?own:Robot.t ->
  ?units:Units.t ->
  ?named:Named_constants.t ->
  ?batch:bool ->
  ?banner:string list ->
  Step.Ir.program ->
  t
(** [units]: the units for the comments of struct members; {!Units.none} by default. [named]: the
    constants that keep their names; {!Named_constants.none} by default. [batch]: also generates
    {!Batch}; false by default. [banner]: lines for the comment at the top of both files. *)
