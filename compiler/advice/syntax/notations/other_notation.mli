(** Expressions in the notation of C, Python or MATLAB, rewritten in the notation of Frob. *)

val expression : string -> string option
(** The expression in Frob: [max(0, min(a, b))] becomes [max 0 (min a b)], and [x > 0 and not y]
    becomes [x > 0 && not y]. An expression that is already in Frob keeps its meaning. [None] if the
    text contains anything unknown. *)

val arguments : string -> string list option
(** The expressions between the commas of an argument list, in Frob. Empty for an empty text. *)
