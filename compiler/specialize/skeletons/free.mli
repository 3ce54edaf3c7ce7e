(** The free variables of the code that closures are made of.

    Code is named by the id of what it binds first: a lambda's binder, a proc's input, a polymorphic
    local function's own binder. *)

type table

val table : unit -> table

val expr : table -> Core.Ir.expr -> unit
(** Enters all the code inside a closed expression; to be called once for each definition. *)

val of_code : table -> int -> Variables.Set.t

val uses_binder : table -> int -> bool
(** Does the body of the lambda or proc mention its parameter? *)
