(** How nearly a condition holds, as a formula over columns of a run.

    Its value is a number at each instant: above 0 the condition is True, below 0 it is False, and
    how far from 0 says how nearly it is something else. That is the robustness of signal temporal
    logic: a comparison is a difference, [And] the least, [Or] the largest, [Not] the negation, and
    what asks for the past is the least or the largest over the instants that it asks for.

    It is computed where all instants of a run are at hand, and not by the program: a window of time
    would need as much memory as there are instants in it. *)

type t =
  | Constant of bool
  | Column of int
      (** a Float, itself; a Bool, which is True or False and never nearly so; by number, from 1 *)
  | Not of t
  | And of t * t
  | Or of t * t
  | Choice of t * t * t  (** the second where the first holds, else the third *)
  | Timed of { operator : string; time : int option; conditions : t list }
      (** a function of the library's module Past, and the column of its time *)

val not_ : t -> t
val and_ : t -> t -> t
val or_ : t -> t -> t

val choice : t -> t -> t -> t
(** These leave out what makes no difference. *)

val to_json : (int -> string) -> t -> string
(** With the names of columns: [["and", "f.margin a 1", ["within", "f.margin a 2", …]]]; a constant
    is [true] or [false]. *)
