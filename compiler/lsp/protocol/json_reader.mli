(** JSON as others write it.

    Strings come out as well-formed UTF-8: half a surrogate pair, and bytes that are no UTF-8,
    become [U+FFFD]. *)

open Basis

val of_string : string -> Json.t option
(** [None] if the text is no JSON, or nested more than 500 deep. *)

(** {1 Looking into it}

    A message that lacks something has a default in its place. *)

val member : string -> Json.t -> Json.t
(** [Null] if it is not there. *)

val at : string list -> Json.t -> Json.t
(** [at [a; b] json] is the member [b] of the member [a]. *)

val string : Json.t -> string option
val int : Json.t -> int option
val list : Json.t -> Json.t list
