(** The input or output type of a program as a C struct.

    A record's fields are members; a tuple's components are [f1], [f2], …; a
    value that is neither is the one member [value]. What holds nothing holds
    one byte, because C has no empty structs. *)

type types
(** The record types of one header, as they are met. *)

val types : Name.scope -> prefix:string -> sum:(int -> string) -> types
(** [sum] gives the struct of a sum. *)

type t = {
  struct_name : string;
  leaves : string list list;  (** the members that lead to each leaf, in order *)
  unused : string list list;  (** and to the bytes of what holds nothing *)
}

val of_shape : types -> name:string -> Flow.Ir.shape -> t
(** [name] is that of the struct, a name of the header's scope. *)

val definitions : types -> Ir.declaration list
(** All structs, used before users. *)

val direct : Flow.Ir.shape -> bool
(** A record, so that members bear the programmer's names. *)
