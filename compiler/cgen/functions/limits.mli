(** Finds numbers whose only use is to limit another number to a symmetric range. In [limit] of the
    module Control, for example, [most = max 0 x] is only used in [max (-most) (min most y)]. One C
    function computes both maxima and the minimum, and needs fewer instructions because the sign of
    a zero in [most] does not matter. *)

val limited : Step.Ir.expr -> (Step.Ir.expr * Step.Ir.expr) option
(** Matches [max (-most) (min most y)], and returns [most] and [y]. *)

val in_body : Step.Ir.statement list -> Step.Ir.expr Basis.Int_table.t
(** Maps the id of each such variable [most] in the body of a function to its [x]. *)
