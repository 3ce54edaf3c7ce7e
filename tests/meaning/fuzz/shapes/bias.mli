(** What the programs of a seed have most of. *)

(** What a program is. *)
type root =
  | Any  (** equations and definitions of all kinds *)
  | Small  (** see {!Small_root} *)
  | Cascade  (** see {!Cascade} *)
  | Handed_on  (** see {!Handed_on} *)

type t = {
  events : int;  (** one type in so many is an event *)
  switches : int;  (** the weight of switches among signal functions *)
  tasks : int;  (** the weight of tasks among signal functions *)
  library : int;  (** the weight of the event library *)
  odd_numbers : int;  (** one constant in so many is NaN, infinite or extreme *)
  depth : int;  (** added to the depth of expressions *)
  width : int;  (** added to the number of equations *)
  chains : int;  (** the weight of chains of array functions among expressions *)
  root : root;
}

val alike : int
(** So many programs in a row are of one kind. *)

val of_program : seed:int -> int -> t
(** Of the program with this number, by turns: even, event-heavy, switch-storms, NaN-heavy, deep,
    wide, array-heavy, with a small root, cascades of modes, modes that hand on numbers. *)

val count : int
(** How many there are. *)
