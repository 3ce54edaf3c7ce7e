(** Step as text, for dumps and tests. Variables whose name is not the only one of its kind in a
    function show their number too. *)

val ty : Ir.program -> Ir.ty -> string
val program : Format.formatter -> Ir.program -> unit
