(** The worst case of a step: operations of each kind, callees included.

    An operation of the language counts once in its kind, also where its C needs
    a few instructions more, as integers that wrap around and conversions that
    saturate do. Of two branches the larger number of each kind counts; of
    [&&] and [||] both sides; of a machine, in each of the steps that it can
    take within one instant, the largest of its modes with all its transitions
    tested and the largest entry. So no step does more of any kind. *)

type t = { reset : Cost.t; step : Cost.t }

val of_program : Machine.Ir.program -> t
(** Of the root. *)
