(** What nodes pass for each other's parameters. *)

type call = { callee : int; arguments : (Ir.argument * Ir.atom) array }
(** What one node passes for the parameters of another. *)

val parameters : Ir.node -> Ir.signal array
(** Its statics, then its inputs. *)

val places : Ir.program -> Ir.atom -> (int * int) option
(** The node that the atom is a parameter of, and its number there. *)

val settle : Ir.program -> (call -> bool) -> unit
(** Visits all calls, those of callers before those of callees, until nothing more is changed: a
    visit tells if it changed anything. What enters a mode is a call too, and passes on the inputs.
*)

val replaced : Ir.program -> (int -> int -> Ir.atom option) -> Ir.program
(** With what stands for some parameters, by node and number, in place of them. The very same
    program if there are none. *)
