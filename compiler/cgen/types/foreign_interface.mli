(** The calling convention of the user's C functions.

    Numbers, Bools and the addresses of foreign values are passed directly. A sum or a copyable
    foreign value is passed by address, an array of numbers by the address of its first element, and
    a record by the address of its struct. For everything else, such as a tuple, the program defines
    a struct. A result that cannot be returned directly is written to the place that the last
    parameter points to.

    A component in C has the same interface as a program with that name. *)

type passing =
  | Nothing  (** for [()] *)
  | Value of Ir.ty
  | Address of Ir.ty  (** the address of a value of this type *)
  | Elements of Ir.ty  (** the address of the first element *)
  | Struct of Interface.t  (** the address of this struct *)

type t = { symbol : string; form : form }

and form =
  | Function of { arguments : passing list; result : passing }
  | Component of { input : Interface.t; output : Interface.t }

val of_import : Interface.types -> fresh:(string -> string) -> Flow.Ir.import -> t
(** [fresh] returns names for unnamed structs. *)

val state : string -> string

val reset : string -> string
(** The reset function of the component with this name. *)

val step : string -> string
val prototypes : t -> Ir.function_ list
