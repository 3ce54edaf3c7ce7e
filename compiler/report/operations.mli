(** The worst case of a step: operations of each kind, callees included.

    An operation of the language counts once in its kind, also where its C needs a few instructions
    more, as integers that wrap around and conversions that saturate do. Of two branches the larger
    number of each kind counts; of [&&] and [||] both sides; of a machine, of all chains of modes
    that one instant can take it through, the largest number of each kind, with all transitions of
    each mode tested. So no step does more of any kind. *)

type t = { reset : Cost.t; step : Cost.t }

val of_program : Step.Ir.program -> t
(** Of the root. *)
