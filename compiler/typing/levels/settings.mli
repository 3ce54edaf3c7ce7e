(** A choice between two settings of a signal function, which must be static. *)

open Basis

val hint :
  Source.t -> value:(Ir.Local.t -> Ir.expr option) -> head:Ir.expr -> input:Ir.expr -> string option
(** The equations that run one instance for each setting, and the choice between their outputs, if
    an argument of [head] chooses between constants, as in [lowPass (if c then 1[s] else 2[s]) x],
    or is a variable with such a [value]. *)
