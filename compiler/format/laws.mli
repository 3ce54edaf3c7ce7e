(** The properties that the formatter guarantees. *)

type t =
  | Tree  (** the result parses to the same program *)
  | Comments  (** the result has the same comments in the same order *)
  | Rest  (** the result does not change when it is formatted again *)

val broken : Reading.t -> Reading.t -> t option
(** The law that a result breaks, given the program before and after. Never {!Rest}, which requires
    another run of the formatter. *)

val name : t -> string
