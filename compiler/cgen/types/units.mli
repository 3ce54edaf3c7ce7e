(** The units that comments state for the members of generated structs.

    Step has no units. Callers that have the types of the program supply the units in this form;
    units affect only comments. A unit is a string such as [m/s], or [""] if the value is not a
    number, is a plain number, or has an unknown unit. *)

type value = {
  unit_ : string;
  part : string -> value;
      (** the units of the fields by name, or of the components by number, from 1 *)
}
(** The units of a value and of its parts. An array has the units of its elements. *)

type t = {
  input : value;  (** the program's input *)
  output : value;
  record : Flow.Ir.product -> value;
      (** the units in a record's declaration, which all uses of the record share *)
  field : Step.Ir.field -> string;  (** the unit of a member of the state *)
}

val unknown : value
val none : t
