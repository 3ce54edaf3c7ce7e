(** What the formatter promises of its result. *)

type t =
  | Tree  (** the program is the same *)
  | Comments  (** they are the same, in the same order *)
  | Rest  (** formatted again it stays as it is *)

val broken : Reading.t -> Reading.t -> t option
(** Which law this result of a program breaks; never {!Rest}, which asks for another run. *)

val name : t -> string
