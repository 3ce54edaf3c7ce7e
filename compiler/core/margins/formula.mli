(** The margin of a condition, as a formula over the columns of a recorded run.

    The value of the formula is a number at each instant. If it is positive, the condition is True;
    if it is negative, False. Its distance from 0 tells how close the condition is to changing. This
    is the robustness of signal temporal logic: a comparison is a difference, [And] is the minimum,
    [Or] the maximum, [Not] the negation, and an operator on the past is the minimum or maximum over
    the instants that it refers to.

    The formula is evaluated after the run, when all instants are available. The program does not
    evaluate it, because a time window would need memory for all the instants in it. *)

type t =
  | Constant of bool
  | Column of int
      (** a column number, from 1. A Float column is the margin itself; a Bool column is only True
          or False, without a distance *)
  | Not of t
  | And of t * t
  | Or of t * t
  | Choice of t * t * t  (** the second formula when the first is true, otherwise the third *)
  | Timed of { operator : string; time : int option; conditions : t list }
      (** a function from the library's Past module, and the column of its time argument *)

val not_ : t -> t
val and_ : t -> t -> t
val or_ : t -> t -> t

val choice : t -> t -> t -> t
(** These four functions build formulas and simplify trivial cases. *)

val to_json : (int -> string) -> t -> string
(** Writes the formula with column names: [["and", "f.margin a 1", ["within", "f.margin a 2", …]]];
    a constant is [true] or [false]. *)
