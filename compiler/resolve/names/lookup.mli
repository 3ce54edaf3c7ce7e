(** Looks up module-level names, and reports names that are undefined or ambiguous. *)

val find : Scope.t -> 'a Interface.space -> Syntax.Ir.qualified -> 'a option
(** Looks up a name. Reports it if it is unknown or ambiguous. *)

val find_value :
  Scope.t ->
  locals:string list Lazy.t ->
  around:Syntax.Ir.right list ->
  Syntax.Ir.qualified ->
  Interface.value option
(** Like {!find}, for values. If there is no such value, reports the name, together with the local
    names and the right-hand sides [around] it. *)

val find_size : Scope.t -> Syntax.Ir.qualified -> int option
(** The number that a capitalized name represents in an expression, if the name is a size and not a
    constructor: 25 for [N], after [type N = 25]. *)
