(** The machines in a program's state, for hosts that show which mode runs. *)

type t = {
  name : string;  (** from the source; unique in the list *)
  path : string;  (** from the state struct to the number of the mode that runs *)
  wide : bool;  (** that number has 32 bits, not 8 *)
  modes : string list;  (** names, by number *)
  within : (int * int) option;
      (** a machine, by its place in the list, and the number of its mode that has to run for this
          one to do so *)
}

val of_program : Vocabulary.t -> t list
(** Each after the machine it is within. Without those of one mode, and those in long arrays. *)
