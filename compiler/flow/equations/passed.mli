(** The arguments that nodes pass to each other. *)

type call = { callee : int; arguments : (Ir.argument * Ir.atom) array }
(** A call: the arguments for the callee's parameters. *)

val parameters : Ir.node -> Ir.signal array
(** The static parameters, then the inputs. *)

val places : Ir.program -> Ir.atom -> (int * int) option
(** If the atom is a parameter of a node, returns the node's index and the parameter's index in the
    node's {!parameters}. *)

val settle : Ir.program -> (call -> bool) -> unit
(** Visits all calls, those in callers before those in callees. The visitor returns whether it has
    learned anything new about the callee's parameters; if so, the calls that pass these parameters
    on are visited again. A transition to a mode counts as a call that also passes the inputs. *)

val replaced : Ir.program -> (int -> int -> Ir.atom option) -> Ir.program
(** Replaces parameters, identified by node and index, with atoms. Returns a program physically
    equal to its argument if nothing is replaced. *)
