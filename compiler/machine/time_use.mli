(** Who reads the time since the instant before. *)

val by_one_mode : Ir.program -> Ir.node -> bool
(** The seconds are read by only one of several modes of the node's machine, and nothing
    else: they need computing only where that mode is stepped. A machine with instants of its
    own, whose time is not the node's, does not count. *)

(** Modes by their numbers. *)
type modes =
  | In of int list
  | Not_in of int list

val only_in_modes : Ir.program -> Ir.node -> modes option
(** The modes of the root's machine that read the time, if others and all else do not: it
    is computed only where one of these runs. [None] as well

    - where it is one mode alone: C compilers take such a step apart, and it grows;
    - where telling them would take more than two comparisons;
    - where several read seconds, which are made at once;
    - where a mode can be entered before the one that runs is stepped;
    - in single precision, where there is little to compute. *)

val rounded_by_modes : Ir.program -> int list
(** The modes, by their nodes, that are given dt as it comes and make whole nanoseconds of
    it themselves, so that the program need not ask which mode runs before it runs it: those of
    {!only_in_modes} that are {!In}, where

    - none of them reads seconds, which are made of the nanoseconds;
    - they are modes of the root and nothing else, for what others step has nanoseconds given;
    - the first dt needs no 0 in its place, which the root alone could tell. *)

val nanoseconds_in_floats : Ir.program -> Ir.node -> bool
(** The root's nanoseconds stay the double that they are made as, for modes to make
    integers of them where they count in them: unless its machine has instants of its
    own, of which it adds up the time, or they are computed in only some modes
    ({!only_in_modes}), of which none reads seconds. Where Floats are of single
    precision the step is given integers. *)

val divides : Ir.program -> bool
(** Something is divided by them, as a derivative is: where they are made by a division
    too, one would wait for the other. *)
