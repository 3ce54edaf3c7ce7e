(** The calls that lead to a place, innermost first. Each has the name of the function and the place
    of the call. *)

type t = (string * Basis.Span.t) list
