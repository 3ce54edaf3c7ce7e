(** The machines in a program's state, for hosts that show the running modes. *)

type t = {
  name : string;  (** from the source; unique in the list *)
  path : string;  (** path from the state struct to the number of the running mode *)
  wide : bool;  (** whether this number has 32 bits instead of 8 *)
  modes : string list;  (** names of the modes, by number *)
  within : (int * int) option;
      (** the enclosing machine's index in the list, and the number of the mode that contains this
          machine *)
}

val of_program : Program_names.t -> t list
(** Each machine follows the one that contains it. Machines with a single mode, and those in long
    arrays, are omitted. *)
