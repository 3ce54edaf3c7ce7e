(** An array of signal functions that are run by a lambda on its elements. *)

val of_application : Ir.expr -> Ir.expr -> Ir.expr_desc option
(** Of the function and its last argument: [map (\f -> f x) fs] is [parB fs x], and
    [zipWith (\f x -> f x) fs xs] is [parZ fs xs]. *)

val needs : Ir.Global.t list
(** Of the library, whether the program mentions it or not. *)
