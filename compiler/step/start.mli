(** Reset and first step of a node in one: the code of a mode's first instant.

    What enters a mode resets it and steps it at a dt of 0. There each delay has its
    initial value, no time has passed, and a machine is in its first mode; most of the
    step is known then. C compilers see that only where they take a copy of the step to
    each place that enters the mode, so this is done here, once for all of them. *)

val of_node :
  Basis.Real.t ->
  callee:(int -> Ir.node) ->
  weight:(int -> int) ->
  modes:Ir.mode list ->
  outputs:int ->
  reset:Ir.code ->
  step:Ir.code ->
  (Ir.code * int) option
(** The code, and a rough count of its operations with those of the starts that it
    calls ([weight] of a callee's). [modes] are those of its machine, [outputs] those of
    the step that the start has too. None if it would be long, so that the step is better shared, or if there is
    something in it whose first instant is no simple matter (a loop with state, a mode
    that may end at once). *)
