(** The calls that lead to a place, the innermost one first: the name of each function and the place
    of the call. *)

type t = (string * Basis.Span.t) list
