(** The arguments that nodes pass to each other. *)

type call = { callee : int; arguments : (Ir.argument * Ir.atom) array }
(** A call: the arguments for the callee's parameters. *)

val parameters : Ir.node -> Ir.signal array
(** The static parameters, then the inputs. *)

val places : Ir.program -> Ir.atom -> (int * int) option
(** If the atom is a parameter: its node, and its index there. *)

val settle : Ir.program -> (call -> bool) -> unit
(** Visits all calls, in an order in which callers come before callees. A visit returns whether it
    changed what is known about the callee's parameters; if so, the calls that pass these on are
    visited again. A transition to a mode counts as a call that also passes the inputs. *)

val replaced : Ir.program -> (int -> int -> Ir.atom option) -> Ir.program
(** Replaces parameters, given by node and index, by atoms. Returns the same program, physically, if
    there are none. *)
