(** Expressions of a function in C. *)

type names
(** Of one function: its variables, and its node's state. *)

val names : Vocabulary.t -> node:int -> names
val scope : names -> Name.scope
val vocabulary : names -> Vocabulary.t

val index : names -> int -> string
(** Of a loop that is so deep in others. *)

val read_as : names -> Step.Ir.variable -> Ir.expr -> unit
(** How the variable is read from now on. *)

val read_elements_as : names -> Step.Ir.variable -> (Ir.expr list -> Ir.expr) -> unit
(** How an element of the array is read, given an index for each dimension; it is not read
    otherwise. *)

val element : names -> Step.Ir.expr -> Ir.expr -> Ir.expr
(** Of an array, by its index. *)

val variable : names -> Step.Ir.variable -> string
(** Its name, chosen at the first call. *)

val field : names -> Step.Ir.field -> Ir.expr
(** [self->x] *)

val reaches_state : names -> bool
(** Whether any field was reached. *)

val parameters : names -> Step.Ir.variable list -> (Ir.ty * string) list
(** Of a node's function: an array is passed by address. *)

val address : Ir.expr -> Ir.expr

val arguments : names -> Step.Ir.variable list -> Step.Ir.expr list -> Ir.expr list
(** For these parameters of a node's function. *)

val of_step : names -> Step.Ir.expr -> Ir.expr
