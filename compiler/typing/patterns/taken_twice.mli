(** Detects a constructor that a [case] matches twice by mistake. The mistake explains the errors in
    the second branch. *)

val tell :
  Context.t ->
  before:int ->
  taken:(Ir.Global.t * Resolve.Ir.pattern) list ref ->
  Resolve.Ir.branch ->
  Type.t ->
  Resolve.Ir.branch list ->
  unit
(** If this branch has errors, that is, if the number of errors now exceeds [before], replaces the
    last error with that explanation. The last arguments are the type of the matched value and all
    branches. [taken]: the constructors that earlier branches cover completely. *)
