(** Guesses what the programmer meant at a syntax error.

    Newcomers bring habits from Haskell, C and Python. This module recognizes the common ones by the
    token at which the parser stops and the text around it. *)

val hint : Found.t -> state_hints:string list -> Basis.Diagnostic.hint list
(** The hint for the token. If there is none, the hints of the automaton's state. If the state has
    none either, the hint for the most common mistake at such a token. *)

val foreign : Found.t -> (string * Basis.Span.t) option
(** The word or operator from another language at which the parser stops, and its place. *)

val other_place : Found.t -> Basis.Diagnostic.t -> Basis.Diagnostic.t
(** Adds a label at the token that the found token should match, if the two are on different lines.
*)
