(** Suggests how to choose between settings of a signal function at run time, since each setting
    must be static. *)

open Basis
open Typing

val quote : Source.t -> Ir.expr -> string option
(** The source text, if it is short. *)

val is_constant : Ir.expr -> bool
(** Does the expression contain neither local variables nor choices? *)

val hint :
  Source.t -> value:(Ir.Local.t -> Ir.expr option) -> head:Ir.expr -> input:Ir.expr -> string option
(** The hint applies if an argument of [head] chooses between constants, as in
    [lowPass (if c then 1[s] else 2[s]) x], or is a variable with such a [value]. It shows equations
    that run one instance for each setting, and a choice between their outputs. *)
