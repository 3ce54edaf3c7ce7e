(** The structs that C declarations mention.

    Expressions need not be searched: the value of a struct always comes from a variable or a
    function, whose declaration mentions the type. *)

val structs : Ir.declaration list -> string list
(** Names of structs, possibly with duplicates. *)
