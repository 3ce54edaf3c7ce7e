(** The input or output type of a program as a C struct.

    An array is one in C; a record's fields are members; a tuple's components are [f1], [f2], …; a
    value that is neither is the one member [value]. What holds nothing holds
    one byte, because C has no empty structs. *)

type types
(** The record types of one header, as they are met. *)

val types : Name.scope -> prefix:string -> sum:(int -> string) -> types
(** [sum] gives the struct of a sum. *)

type t = {
  struct_name : string;
  leaves : step list list;  (** what leads to each leaf, in order *)
  unused : step list list;  (** and to the bytes of what holds nothing *)
}

and step =
  | Member of string
  | Element of int  (** of an array: any of so many *)

val of_shape : types -> name:string -> Flow.Ir.shape -> t
(** [name] is that of the struct, a name of the header's scope. *)

val definitions : types -> Ir.declaration list
(** All structs, used before users. *)

val direct : Flow.Ir.shape -> bool
(** A record, so that members bear the programmer's names. *)
