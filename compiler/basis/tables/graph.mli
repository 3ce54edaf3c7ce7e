(** Directed graphs over the vertices 0 … n-1.

    Everything here is iterative (a chain of a million vertices is fine) and deterministic: vertices
    are visited in the order of their numbers, edges in the order given. *)

type t = int list array
(** The successors of each vertex. *)

val components : t -> int list list
(** The strongly connected components, each after all components that it leads to, its vertices
    ascending. If an edge means "needs", then the vertices come out in an order of evaluation, and
    as near to the order of their numbers as depth-first search gets. Linear (Tarjan). *)

val is_cyclic : t -> int list -> bool
(** Does this component of {!components} hold a cycle: has it more than one vertex, or an edge to
    itself? *)

val shortest_cycle : t -> int list -> int list
(** A shortest cycle within a cyclic component, in the direction of the edges, from its smallest
    vertex. In a component so large that looking at all cycles would take seconds, the shortest of
    those looked at. *)
