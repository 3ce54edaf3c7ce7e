(** How the user's C is called: what its functions take and give.

    A number, a truth value and the address of a foreign value are passed as they are; a sum or a
    copyable foreign value by address; an array of numbers by the address of its first element; a
    record by the address of its struct. What is none of these, as a tuple, has a struct of its own.
    A result that is not passed as it is goes where the last parameter points to.

    A component in C has the interface that a program of its name would have. *)

type passing =
  | Nothing  (** of [()] *)
  | Value of Ir.ty
  | Address of Ir.ty  (** of this type *)
  | Elements of Ir.ty  (** the address of the first of several *)
  | Struct of Interface.t  (** the address of one *)

type t = { symbol : string; form : form }

and form =
  | Function of { arguments : passing list; result : passing }
  | Component of { input : Interface.t; output : Interface.t }

val of_import : Interface.types -> fresh:(string -> string) -> Flow.Ir.import -> t
(** [fresh] gives the structs without a name of their own one. *)

val state : string -> string

val reset : string -> string
(** Of the component of that name. *)

val step : string -> string
val prototypes : t -> Ir.function_ list
