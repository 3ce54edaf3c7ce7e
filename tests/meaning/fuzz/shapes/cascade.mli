(** Programs that consist mainly of switches, several of which occur at one instant.

    In the generated C, a loop goes from mode to mode within an instant, at most as often as the
    compiler has proved possible; and it does not test whether a mode ends if the compiler has
    proved that the mode lasts beyond its first instant. Both proofs use the ranges of the numbers
    that modes pass on. So the conditions in these modes test such numbers, and the input determines
    whether the numbers are low or high. *)

val one_of_few : ?by:string -> Scope.t -> string
(** An Int whose range the compiler can analyse: often one of two literals, chosen by the Bool [by]
    or by a random one. *)

val asked_of : Scope.t -> string -> string
(** A comparison of the Int, usually with a small one. *)

val bool : Scope.t -> string
(** A Bool that mostly depends on the input, if anything in scope does. *)

val definitions :
  Scope.t -> input:Type.t -> pattern:string * (string * Type.t) list -> string * string list
(** Modes with this input that lead to each other, and signal functions with this input and an Int
    output that each start in one of the modes: the text of all of them, and the names of the signal
    functions. *)
