(** The types of signals as the programmer would write them, with units. *)

type t

val of_program : Typing.Ir.program -> t

val type_of : t -> Catalogue.probe -> Typing.Ir.ty option
(** Of a part of a record or tuple, that part's; of a signal in a polymorphic signal function with
    its variables. [None] where the compiler has made the signal. *)

val part : t -> Typing.Ir.ty -> string list -> Typing.Ir.ty option
(** What is reached by these fields, components (from 1) and elements ([[0]]), as in a column's
    name. *)

val unit_ : Typing.Ir.ty -> string option
(** Of a number, or of an event of one: [m/s], and [N], not [kg m/s^2]; [None] without a unit, and
    if it is open. *)
