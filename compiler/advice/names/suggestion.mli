(** Suggestions of similar names.

    Only the first hundred unknown names of a run get suggestions: computing them takes quadratic
    time, and a longer list would not help the user. *)

open Basis

type t
(** Counts the suggestions of one run. *)

val create : unit -> t

val add : t -> string -> string list Lazy.t -> Diagnostic.t -> Diagnostic.t
(** Adds a hint with the closest of the names, and the fix that replaces the name at the
    diagnostic's place. *)
