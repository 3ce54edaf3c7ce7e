(** The features that dominate each random program. *)

(** The root of a program. *)
type root =
  | Any  (** equations and definitions of all kinds *)
  | Small  (** see {!Small_root} *)
  | Cascade  (** see {!Cascade} *)
  | Handed_on  (** see {!Handed_on} *)
  | Errand  (** see {!Errand} *)

type t = {
  events : int;  (** one type in this many is an event *)
  switches : int;  (** the weight of switches among signal functions *)
  tasks : int;  (** the weight of tasks among signal functions *)
  library : int;  (** the weight of the event library *)
  odd_numbers : int;  (** one constant in this many is NaN, infinite or extreme *)
  depth : int;  (** added to the depth of expressions *)
  width : int;  (** added to the number of equations *)
  chains : int;  (** the weight of chains of array functions among expressions *)
  root : root;
}

val alike : int
(** Number of consecutive programs with the same bias. *)

val of_program : seed:int -> int -> t
(** The bias of the program with this number. The biases alternate: balanced, event-heavy, many
    switches, NaN-heavy, deep, wide, array-heavy, small root, cascades of modes, modes that pass on
    numbers, a single task. *)

val count : int
(** Number of different biases. *)
