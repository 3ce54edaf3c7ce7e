(** The types of random programs: numbers, tuples, arrays and data. *)

type t =
  | Float
  | Measure of measure  (** a Float with a unit *)
  | Int
  | Bool
  | Tuple of t list  (** two or more components, or none *)
  | Array of int * t
  | Data of data

and measure = { metres : int; seconds : int }
(** exponents; not both 0 *)

and data = {
  head : string;  (** in source syntax: [Maybe Float], [Shape3] *)
  constructors : constructor list;
}

and constructor = { name : string; fields : (string * t) list  (** field names, or [""] *) }

val maybe : t -> t
val event : t -> t
val unit : t

val event_payload : t -> t option
(** The payload type of an event type. *)

val measure : metres:int -> seconds:int -> t
(** A Float with a unit of these exponents; without a unit if both are 0. *)

val scalars : t -> int
(** An upper bound on the number of scalars in a value. *)

val unit_text : measure -> string
(** The unit in source syntax, without the brackets. *)

val either : t -> t -> t

val has_instances : measured:bool -> t -> bool
(** Whether the type has an instance of a class that random programs share: [Measured] or [Renewed].
    Declared types have both. *)

val is_record : data -> bool

val text : t -> string
(** In parentheses if needed for an argument of a type. *)

val any_measure : Random.State.t -> measure

val any : Random.State.t -> declared:t list -> t
(** A small random type; [declared] are the program's data types. *)

val declare : Random.State.t -> declared:t list -> string -> t
(** A random data type of this name: a record, a sum or an enumeration. *)

val declaration : t -> string
(** The declaration of a type made by {!declare}. *)
