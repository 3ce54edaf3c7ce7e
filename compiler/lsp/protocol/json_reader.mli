(** Parses JSON.

    Resulting strings are always valid UTF-8: unpaired surrogates and bytes that are not UTF-8
    become [U+FFFD]. *)

open Basis

val of_string : string -> Json.t option
(** [None] if the text is not JSON, or is nested more than 500 levels deep. *)

(** {1 Access}

    If a member is missing, these functions return a default. *)

val member : string -> Json.t -> Json.t
(** [Null] if the member is missing. *)

val at : string list -> Json.t -> Json.t
(** [at [a; b] json] is the member [b] of the member [a]. *)

val string : Json.t -> string option
val int : Json.t -> int option
val list : Json.t -> Json.t list
