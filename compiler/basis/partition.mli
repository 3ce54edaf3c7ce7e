(** The coarsest partition of 0 … n-1 that is a congruence: two elements are
    together if they have the same label and, argument by argument, arguments
    that are together. Cycles are no obstacle: like the states of an automaton,
    elements are together until something tells them apart. *)

val congruence :
  distinct:int -> labels:int array -> arguments:int array array -> int array
(** The class of each element, named by its smallest element. Labels are 0 up to
    [distinct] - 1, each of some element. Elements with equal labels must have
    equally many arguments. In O(m log n) for m arguments (Hopcroft). *)
