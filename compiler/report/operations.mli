(** The worst-case cost of a step: the number of operations of each kind, including callees.

    An operation of the language counts as one, even if it takes several operations in C, as
    wrapping integer arithmetic and saturating conversions do. For branches, the maximum of each
    kind counts. For [&&] and [||], both operands count. For a machine, the cost is the maximum of
    each kind over all chains of modes that one instant can pass through, including the tests of all
    transitions of each mode. No step performs more operations of any kind than this bound. *)

type t = { reset : Cost.t; step : Cost.t }

val of_program : Step.Ir.program -> t
(** The costs of the root's reset and step functions. *)
