(** Dependency analysis of one list of declarations.

    The bindings are numbered 0 … n-1. While the right-hand side of a binding is resolved, its
    references to other bindings are recorded here; then the bindings are sorted into groups. Each
    expression is visited once, however deeply lists of declarations are nested. *)

type t

val create : int -> t

val within : t -> int -> (unit -> 'a) -> 'a
(** Runs a function. References recorded during the call belong to the given binding. *)

val refer : t -> signed:bool -> int -> unit
(** Records a reference to a binding. [signed]: the name has a signature, so its type does not
    depend on its definition. Has no effect outside {!within}. *)

val sort : t -> Ir.binding array -> Ir.binding_group list
(** The groups in dependency order. All references determine the order, but only references to names
    without a signature can put the bindings of a cycle into the same group. *)
