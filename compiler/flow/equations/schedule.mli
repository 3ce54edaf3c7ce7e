(** Orders the computations of a step.

    Requires that the program is causal, and that every instance can run as one call ({!Inline}
    ensures this). Each item comes after all items whose values it needs in the same instant; an
    instance needs all its static parameters and inputs. Apart from that, the items keep the node's
    own order (see {!in_source_order}).

    [Delay] and [Integral] do not need any other item, because their values for this instant are
    already in the state. Their values for the next instant must be stored after all items. *)

type item =
  | Equation of Ir.equation
  | Instance of Ir.instance
  | Trial of Ir.instance * Ir.trial
  | Machine of Ir.machine

val defines : item -> Ir.signal list
(** The signals that the item defines. For an instance, this excludes outputs that a trial step has
    already defined. *)

val needs : item -> Ir.signal list
(** The signals that the item needs in the same instant. *)

val in_source_order : Ir.node -> item list
(** The node's own order: the order of its equations, with each instance before the first equation
    that is written after it. *)

val of_node : Ir.node -> item list
(** Raises {!Basis.Diagnostic.Bug} on a cycle. *)

val as_far_as_possible : Ir.node -> item list
(** Like {!of_node}, but also works for nodes that are not inlined yet: the items of a cycle keep
    the node's own order. Also puts the items that compute the initial values of delays and machines
    before those delays and machines. *)

val loops : Ir.node -> Ir.instance list list
(** For each cycle of items, the instances in it, which cannot run as single calls. Empty if
    {!of_node} succeeds. *)
