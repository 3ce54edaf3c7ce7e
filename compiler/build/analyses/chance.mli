(** Statements about probability: a property holds in at least a given proportion of all runs.

    The decision is made run by run, with Wald's sequential test (A. Wald, Sequential Tests of
    Statistical Hypotheses, 1945). Two tests, one for each side, compare the allowed failure rate
    with a quarter of that rate and with four times that rate. If the true proportion is smaller
    than required, the probability of the verdict "holds" is at most 1 - confidence, no matter how
    many runs are made (Ville's inequality), and vice versa. If the failure rate is between half and
    twice the allowed one, the decision may take many runs. *)

type t = { share : float; confidence : float  (** both between 0 and 1 *) }

type decision =
  | Holds  (** it holds in at least the required proportion of runs *)
  | Fails  (** it holds in a smaller proportion of runs *)
  | Open  (** not decided yet *)

val decide : t -> bool list -> decision * int
(** Decides from the outcomes of runs, in order: [true] if the property held. Also returns the
    number of runs that the decision took. *)

val bounds : confidence:float -> held:int -> int -> float * float
(** A confidence interval for the proportion of all runs in which the property holds, given that it
    held in [held] of a sample of this many runs: the Clopper–Pearson interval (Biometrika 26,
    1934), which is never too narrow. *)
