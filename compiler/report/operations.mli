(** The worst-case cost of a step: the number of operations of each kind, including callees.

    An operation of the language counts as one, even if C needs several instructions for it, for
    example for integers that wrap around and for saturating conversions. For branches, the maximum
    of each kind counts. For [&&] and [||], both operands count. For a machine, the cost is the
    maximum of each kind over all chains of modes that one instant can pass through, including the
    tests of all transitions of each mode. No step performs more operations of any kind than this
    bound. *)

type t = { reset : Cost.t; step : Cost.t }

val of_program : Step.Ir.program -> t
(** The costs of the root's functions. *)
