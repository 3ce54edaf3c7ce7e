(** Recognizes a lambda that runs each element of an array of signal functions. *)

val of_application : Ir.expr -> Ir.expr -> Ir.expr_desc option
(** Takes the function and its last argument: [map (\f -> f x) fs] becomes [parB fs x], and
    [zipWith (\f x -> f x) fs xs] becomes [parZ fs xs]. *)

val needs : Ir.Global.t list
(** The library definitions that the rewriting needs, even if the program does not mention them. *)
