(** Directed graphs over the vertices 0 … n-1.

    All functions are iterative (a chain of a million vertices is fine) and deterministic: vertices
    are visited in numerical order, edges in the given order. *)

type t = int list array
(** The successors of each vertex. *)

val components : t -> int list list
(** The strongly connected components, each after all components reachable from it, with its
    vertices in ascending order. If an edge means "needs", this is an evaluation order, as close to
    the numerical order as depth-first search permits. Linear time (Tarjan). *)

val is_cyclic : t -> int list -> bool
(** Does this component from {!components} contain a cycle: more than one vertex, or an edge from a
    vertex to itself? *)

val shortest_cycle : t -> int list -> int list
(** A shortest cycle within a cyclic component, in the direction of the edges, starting at its
    smallest vertex. If the component is so large that a full search would take seconds, the search
    stops early, and the result may not be the shortest cycle. *)
