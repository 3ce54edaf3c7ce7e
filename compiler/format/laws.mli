(** The properties that the formatter guarantees. *)

type t =
  | Tree  (** the result must parse to the same program *)
  | Comments  (** the result must have the same comments in the same order *)
  | Rest  (** formatting the result again must not change it *)

val broken : Reading.t -> Reading.t -> t option
(** The law that the formatted program breaks, if any. Never returns {!Rest}, because that requires
    another run of the formatter. *)

val name : t -> string
