(** Counts operations by kind. *)

type kind =
  | Additions  (** additions, including subtractions and negations *)
  | Multiplications
  | Divisions  (** including remainders *)
  | Choices  (** comparisons, logic, and all branches *)
  | Conversions  (** conversions between integers, floats and nanoseconds *)
  | Calls of string
      (** calls of this function: an elementary function, a kernel, [fabs], or one of the user's C
          functions *)
  | Pixels of string  (** pixels that this kernel reads, if their number is known *)
  | Images of string  (** calls of this kernel that may read a whole image *)
  | Loads  (** loads of a scalar from the state *)
  | Stores

type t

val none : t
val one : kind -> t
val several : int -> kind -> t
val add : t -> t -> t
val sum : t list -> t

val larger : t -> t -> t
(** The maximum for each kind. *)

val times : int -> t -> t
val count : t -> kind -> int

val calls : t -> (string * int) list
(** The functions that are called, with the number of calls. *)
