(** How many operations of each kind. *)

type kind =
  | Additions  (** subtractions and changes of sign too *)
  | Multiplications
  | Divisions  (** remainders too *)
  | Choices  (** comparisons, logic, and everything that takes one of two ways *)
  | Conversions  (** between integers, floats and nanoseconds *)
  | Calls of string  (** of this elementary function, kernel or function of the user's, or [fabs] *)
  | Pixels of string  (** that this kernel looks at, as far as that is known *)
  | Images of string  (** calls of this kernel that may look at all of an image *)
  | Loads  (** of a scalar of the state *)
  | Stores

type t

val none : t
val one : kind -> t
val several : int -> kind -> t
val add : t -> t -> t
val sum : t list -> t

val larger : t -> t -> t
(** Of each kind the larger number. *)

val times : int -> t -> t
val count : t -> kind -> int

val calls : t -> (string * int) list
(** Of elementary functions, by name. *)
