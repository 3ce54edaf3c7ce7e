(** The types of random programs: numbers, tuples, arrays and data. *)

type t =
  | Float
  | Measure of measure  (** a Float with a unit *)
  | Int
  | Bool
  | Tuple of t list  (** two or more, or none *)
  | Array of int * t
  | Data of data

and measure = { metres : int; seconds : int }
(** exponents; not both 0 *)

and data = {
  head : string;  (** as it is written: [Maybe Float], [Shape3] *)
  constructors : constructor list;
}

and constructor = { name : string; fields : (string * t) list  (** names, or [""] *) }

val maybe : t -> t
val event : t -> t
val unit : t

val event_payload : t -> t option
(** What an event type carries. *)

val measure : metres:int -> seconds:int -> t
(** A Float with a unit of these exponents, or without. *)

val scalars : t -> int
(** How many a value has at most, or more. *)

val unit_text : measure -> string
(** As it stands between brackets. *)

val either : t -> t -> t

val has_instances : measured:bool -> t -> bool
(** Of the classes that random programs share: [Measured], else [Renewed]. Declared types have both.
*)

val is_record : data -> bool

val text : t -> string
(** In parentheses where an argument needs them. *)

val any_measure : Random.State.t -> measure

val any : Random.State.t -> declared:t list -> t
(** A small type; [declared] are data types of the program. *)

val declare : Random.State.t -> declared:t list -> string -> t
(** A data type of that name: a record, a sum or an enumeration. *)

val declaration : t -> string
(** Of what {!declare} made. *)
