(** Prints Step for dumps and tests. A variable is printed with its number if its name is not unique
    in the function. *)

val ty : Ir.program -> Ir.ty -> string
val program : Format.formatter -> Ir.program -> unit
