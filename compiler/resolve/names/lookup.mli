(** Finds the meaning of module-level names, and reports names that have none. *)

val find : Scope.t -> 'a Interface.space -> Syntax.Ir.qualified -> 'a option
(** Looks up a name. Emits a diagnostic if it is unknown or ambiguous. *)

val find_value :
  Scope.t ->
  locals:string list Lazy.t ->
  signals:Proc_signals.t list Lazy.t ->
  Syntax.Ir.qualified ->
  Interface.value option
(** Like {!find}, for values. Suggestions include the local names. [signals]: the signals of [proc]s
    in the definition; the ones in scope are also among the locals. *)

val find_size : Scope.t -> Syntax.Ir.qualified -> int option
(** The number that a capitalized name represents in an expression, if the name is a size and not a
    constructor: 25 for [N], after [type N = 25]. *)
