(** An order in which one step can compute a node's signals.

    Takes for granted that the program is causal and that every instance can run as one call, as
    {!Inline} leaves it: an item comes after all items whose values of the same instant it needs,
    and an instance needs all its statics and inputs. Where that leaves a choice, the order is the
    node's own, instances placed by their spans.

    [Delay] and [Integral] need nothing here: an item of one stands for its value at this instant,
    which is in the state; what it keeps for the next instant is to be stored after all items. *)

type item =
  | Equation of Ir.equation
  | Instance of Ir.instance
  | Trial of Ir.instance * Ir.trial
  | Machine of Ir.machine

val defines : item -> Ir.signal list
(** What an instance gives on trial it does not define again. *)

val needs : item -> Ir.signal list
(** Those whose value of the same instant it needs. *)

val in_source_order : Ir.node -> item list
(** The node's own order: that of its equations, each instance before the first equation that is
    written after it. *)

val of_node : Ir.node -> item list
(** Raises {!Basis.Diagnostic.Bug} on a cycle. *)

val as_far_as_possible : Ir.node -> item list
(** Like {!of_node}, but for nodes not yet inlined: within a cycle of items the order is the node's
    own. What a delay or a machine starts with comes before it too. *)

val loops : Ir.node -> Ir.instance list list
(** The instances in each cycle of items: those that cannot run as one call. Empty where {!of_node}
    succeeds. *)
