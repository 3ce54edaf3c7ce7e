(** The input or output type of a program as a C struct.

    Arrays become C arrays, and the fields of a record become members. The components of a tuple are
    called [f1], [f2], …. Any other value is a struct with the single member [value]. An empty value
    occupies one byte, because C does not allow empty structs. *)

type types
(** The record types of one header. A type is added when it is first used. *)

val types :
  Name.scope ->
  real:Basis.Real.t ->
  prefix:string ->
  sum:(int -> string) ->
  foreign:(Flow.Ir.foreign_type -> Ir.ty) ->
  units:Units.t ->
  types
(** [real] is the type of a Float; [sum] returns the struct of a sum; [foreign] returns the C type
    of a foreign type; the comments of members state their [units]. *)

type t = {
  struct_name : string;
  leaves : step list list;  (** path to each leaf, in order *)
  unused : step list list;  (** paths to the bytes of empty values *)
}

and step = Member of string | Element of int  (** any element of an array of this size *)

val is_in_array : step list -> bool

val dimensions : step list -> int
(** The number of arrays on the path. *)

val leaf_type : types -> Flow.Ir.ty -> Ir.ty

val of_shape : types -> units:Units.value -> name:string -> Flow.Ir.shape -> t
(** [name] is the name of the struct in the header's scope; [units] are the units of the shape. *)

val of_record : types -> name:string -> Flow.Ir.product -> t
(** Like {!of_shape}, but later uses of the record share this struct. *)

val of_type : types -> name:(unit -> string) -> Flow.Ir.shape -> t
(** Like {!of_shape}, but all uses of a record share one struct. *)

val apart : Flow.Ir.shape -> Flow.Ir.shape * Flow.Ir.shape option
(** Splits the output of a program into the robot's command and, if the program can end, its result.
*)

val record_of : (string * Flow.Ir.shape) list -> Flow.Ir.shape
(** A record of the signals that a program outputs as probes. *)

val with_others : types -> name:string -> first:string -> t -> (string * Flow.Ir.shape) list -> t
(** A struct whose member [first] is a struct defined elsewhere, followed by other members, such as
    the program's result. *)

val with_leaves : at:int -> int -> t -> t
(** [with_leaves ~at count interface] moves the last [count] leaves to the position after the first
    [at] leaves. *)

val definitions : types -> Ir.declaration list
(** All structs. Each is defined before it is used. *)

val direct : Flow.Ir.shape -> bool
(** Whether the shape is a record. If so, its members have the names that the programmer gave them.
*)
