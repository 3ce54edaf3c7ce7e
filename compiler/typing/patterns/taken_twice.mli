(** A constructor that a [case] matches twice, where another one was meant: what is wrong in the
    second branch comes of that. *)

val tell :
  Context.t ->
  before:int ->
  taken:(Ir.Global.t * Resolve.Ir.pattern) list ref ->
  Resolve.Ir.branch ->
  Type.t ->
  Resolve.Ir.branch list ->
  unit
(** Of this branch, after which there are more errors than [before], among all branches of a value
    of that type. [taken] are the constructors of which an earlier branch takes all values. *)
