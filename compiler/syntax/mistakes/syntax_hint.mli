(** What the programmer probably meant, where the text breaks off.

    Newcomers bring habits from Haskell, C and Python; this knows the common ones by the token at
    which the grammar stops and what stands around it. *)

val own_operator : string
(** Hint for who writes operators of his own. *)

val reserved_word : string -> string
(** What is said of such a word where a name should stand. *)

val names_before : Found.t -> string -> bool
(** The line up to here has this word. *)

val by_indentation : string
(** Hint for who writes blocks in braces. *)

val hint : Found.t -> state_hints:string list -> string list
(** What the token suggests; else what was said for the automaton's state; else what usually goes
    wrong at such a token. *)

val foreign : Found.t -> (string * Basis.Span.t) option
(** The word or operator of other languages at which the text breaks off, and where it is. *)

val other_place : Found.t -> Basis.Diagnostic.t -> Basis.Diagnostic.t
(** Labels what the token should have gone with, if that is on another line. *)
