(** Sets of values, as an analysis knows them: numbers as ranges, values of data types as the
    constructors they may have and what may be in each, arrays as all their elements together. *)

type t =
  | Bools of { true_ : bool; false_ : bool }  (** which it may be *)
  | Ints of { least : int; most : int }
  | Floats of { least : float; most : float; nan : bool }
      (** no numbers at all if [least > most]; the bounds are no NaN *)
  | Constructors of (int * t list option) list
      (** ascending; with the leaves of the payload, where anything is known of them *)

val anything : Ir.program -> Ir.ty -> t
val of_constant : Ir.atom -> t option

val zero : t
(** The Float. *)

val zero_or : nan:bool -> t

val not_negative : t
(** All Floats from 0 to infinity. *)

val join : t -> t -> t

val widen : steps:int list -> t -> t -> t
(** The join with the second, its bounds that move being infinite; those of Ints are the next one of
    the steps. *)

val meet : t -> t -> t option
(** What is in both; [None]: nothing is. *)

val compared : Ir.operator -> t -> t -> bool -> (t * t) option
(** What two numbers of these ranges may be where the comparison ([Less], [Less_equal], [Equal]) is
    true, or is false; [None]: it never is. *)

val may_be_true : t -> bool
val may_be_false : t -> bool
val has_constructor : t -> int -> t

val payload : t -> int -> int -> t option
(** A leaf of what is in a value that has this constructor and surely no other; [None]: it may be
    anything. *)

val operation : Basis.Real.t -> Ir.operator -> t list -> Ir.ty -> t
(** [Ir.ty]: of the result. *)
