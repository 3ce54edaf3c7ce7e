(** Derives the consequences of conditions that are true in an instant.

    A mode takes the first of its transitions that occurs, so a later transition matters only if no
    earlier one occurs. This module searches for contradictions in such assumptions: it narrows the
    operands of the conditions, and then recomputes the signals that depend on them. For example, if
    [if w then (Just x) else Nothing] is tested for [Just] and the test succeeds, then [w] is true
    and the payload is [x]. *)

type values = (int, Range.t) Hashtbl.t
(** The possible values of a node's signals. *)

val narrowed :
  values ->
  read:(values -> Ir.atom -> Range.t) ->
  evaluate:(values -> Ir.equation -> Range.t) ->
  Ir.equation list ->
  (Ir.atom * bool) list ->
  values option
(** Narrows the possible values of the node's signals, given [values] and the truth values of these
    atoms. Returns [None] if these atoms cannot have these truth values. The equations must be
    sorted so that each one follows those it reads. Does not change [values]. The result may include
    impossible values, but never excludes possible ones. *)
