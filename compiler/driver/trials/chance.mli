(** Statements about chance: that something holds in at least a share of all runs.

    Decided run after run by Wald's sequential test (A. Wald, Sequential Tests of Statistical
    Hypotheses, 1945), once for each side, against a share of failures that is a quarter, or four
    times, the one that is allowed. Where less than the share hold, it is said to hold with a
    probability of at most 1 - confidence, however long one looks (Ville's inequality); and the
    other way round. Between a half and twice the failures that are allowed it may take long. *)

type t = { share : float; confidence : float  (** both between 0 and 1 *) }

type decision =
  | Holds  (** in at least the share of runs *)
  | Fails  (** in less *)
  | Open  (** neither can be said yet *)

val decide : t -> bool list -> decision * int
(** Of runs in their order, with whether each held; and after how many it was decided. *)

val bounds : confidence:float -> held:int -> int -> float * float
(** Between which the share of all runs lies, of which so many held out of so many: Clopper and
    Pearson's interval (Biometrika 26, 1934), which is never too narrow. *)
