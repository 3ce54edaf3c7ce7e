(** The input or output type of a program as a C struct.

    An array is one in C; a record's fields are members; a tuple's components are [f1], [f2], …; a
    value that is neither is the one member [value]. What holds nothing holds one byte, because C
    has no empty structs. *)

type types
(** The record types of one header, as they are met. *)

val types :
  Name.scope ->
  real:Basis.Real.t ->
  prefix:string ->
  sum:(int -> string) ->
  foreign:(Flow.Ir.foreign_type -> Ir.ty) ->
  types
(** [real] is the type of a Float, [sum] gives the struct of a sum, [foreign] how C has a foreign
    type. *)

type t = {
  struct_name : string;
  leaves : step list list;  (** what leads to each leaf, in order *)
  unused : step list list;  (** and to the bytes of what holds nothing *)
}

and step = Member of string | Element of int  (** of an array: any of so many *)

val is_in_array : step list -> bool
val leaf_type : types -> Flow.Ir.ty -> Ir.ty

val of_shape : types -> name:string -> Flow.Ir.shape -> t
(** [name] is that of the struct, a name of the header's scope. *)

val of_record : types -> name:string -> Flow.Ir.product -> t
(** As {!of_shape}; whoever uses the record from now on gets this struct. *)

val of_type : types -> name:(unit -> string) -> Flow.Ir.shape -> t
(** A record has its own struct, whoever uses it; else as {!of_shape}. *)

val apart : Flow.Ir.shape -> Flow.Ir.shape * Flow.Ir.shape option
(** The output of a program that ends: what it commands, and what it has ended with. *)

val record_of : (string * Flow.Ir.shape) list -> Flow.Ir.shape
(** Of what a probed program shows. *)

val with_others : types -> name:string -> first:string -> t -> (string * Flow.Ir.shape) list -> t
(** A struct of several members: the [first], whose struct is defined elsewhere, and others by name,
    such as what the program has ended with. *)

val with_leaves : at:int -> int -> t -> t
(** So many leaves, the last ones, have their place after so many others. *)

val definitions : types -> Ir.declaration list
(** All structs, used before users. *)

val direct : Flow.Ir.shape -> bool
(** A record, so that members bear the programmer's names. *)
