(** The instant in which a mode ends: its transitions come first.

    What a mode puts out in that instant is dropped, and so is its state: the mode that is entered
    is stepped in the same instant. So once it is known that a transition occurs, the rest of the
    step can be left out, as a person would write it:

    {v
    const bool arrived = frob_hypot(in->x - x, in->y - y) < 0.15;
    *out_arrived = arrived;
    if (!arrived) {
        ...
    }
    v} *)

val possible : Flow.Ir.program -> bool array
(** The modes of machines in which that is so at any transition (none is delayed). None in a program
    with the user's components, which run at every instant. *)

val needed : Fragment.t -> Fragment.ending -> bool array
(** The items that are needed where the mode ends. *)

val find :
  fresh:(unit -> int) ->
  resolve:(Flow.Ir.atom -> Flow.Ir.atom) ->
  Flow.Ir.node ->
  Fragment.t ->
  Fragment.t
(** The step of that node, a mode for which it is possible, with its [ending]. [resolve] looks
    through copies. *)
