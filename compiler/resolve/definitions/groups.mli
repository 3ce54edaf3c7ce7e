(** Dependency analysis of the bindings of one list of declarations.

    The bindings have the numbers 0 … n-1. While the right side of one is resolved, each reference
    to another is noted here; then the bindings are sorted into groups. Nothing is walked twice,
    however deeply lists of declarations are nested in each other. *)

type t

val create : int -> t

val within : t -> int -> (unit -> 'a) -> 'a
(** Runs a function; references meanwhile are those of this binding. *)

val refer : t -> signed:bool -> int -> unit
(** Notes a reference to a binding; [signed] if the name used has a signature, so that its type does
    not depend on its definition. Outside of {!within} it has no effect. *)

val sort : t -> Ir.binding array -> Ir.binding_group list
(** In dependency order. All references count for the order; where they run in a circle, only those
    to names without signature hold a group together. *)
