(** The free variables of closures' code.

    Code is identified by the id of its first binder: the parameter of a lambda, the input of a
    proc, or the binder of a polymorphic local function. *)

type table

val table : unit -> table

val expr : table -> Core.Ir.expr -> unit
(** Adds all the code inside a closed expression. Call it once for each definition. *)

val size : table -> int
(** The total number of expressions. *)

val of_code : table -> int -> Variables.Set.t

val uses_binder : table -> int -> bool
(** Does the body of the lambda or proc mention its parameter? *)
