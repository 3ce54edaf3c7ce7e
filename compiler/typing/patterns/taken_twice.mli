(** Detects a constructor that a [case] matches twice by mistake. The mistake explains the errors in
    the second branch. *)

val tell :
  Context.t ->
  before:int ->
  held:Fact.t Basis.Facts.held list ->
  taken:(Ir.Global.t * Resolve.Ir.pattern) list ref ->
  Resolve.Ir.branch ->
  Type.t ->
  Resolve.Ir.branch list ->
  unit
(** Passes on the held facts about this branch. If the branch matches a constructor in [taken], and
    the number of errors has risen above [before], replaces the last fact with the explanation that
    the constructor is matched twice. The last two arguments are the type of the matched value and
    the list of all branches. [taken]: the constructors that earlier branches cover completely. *)
