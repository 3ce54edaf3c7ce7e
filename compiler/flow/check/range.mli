(** Abstract values for static analysis. A number is represented by a range, a value of a data type
    by its possible constructors with the ranges of their payloads, and an array by a single
    abstract value that covers all elements. *)

type t =
  | Bools of { true_ : bool; false_ : bool }  (** whether True and False are possible *)
  | Ints of { least : int; most : int }
  | Floats of { least : float; most : float; nan : bool }
      (** contains no numbers if [least > most]; [nan] tells whether NaN is included; the bounds are
          never NaN *)
  | Constructors of (int * t list option) list
      (** the possible constructors in ascending order, each with the leaves of its payload if
          anything is known about them *)

val anything : Ir.program -> Ir.ty -> t
val of_constant : Ir.atom -> t option

val zero : t
(** The Float 0. *)

val zero_or : nan:bool -> t

val not_negative : t
(** The Floats from 0 to infinity. *)

val join : t -> t -> t

val widen : steps:int list -> t -> t -> t
(** A join that widens the bounds that change: bounds of Floats become infinite, and bounds of Ints
    move to the next value in [steps], or to the end of the Int range if there is none. *)

val meet : t -> t -> t option
(** The intersection; [None] if it is empty. *)

val compared : Ir.operator -> t -> t -> bool -> (t * t) option
(** Restricts the ranges of two numbers, given that their comparison ([Less], [Less_equal] or
    [Equal]) has this truth value; [None] if it never has this value. *)

val may_be_true : t -> bool
val may_be_false : t -> bool
val has_constructor : t -> int -> t

val payload : t -> int -> int -> t option
(** The possible values of a leaf of the payload. [None], which means any value, if they are unknown
    or if the value may have another constructor. *)

val operation : Basis.Real.t -> Ir.operator -> t list -> Ir.ty -> t
(** The range of the result of an operation. The last argument is the type of the result. *)
