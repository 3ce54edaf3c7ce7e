(** What else must hold at an instant if these conditions do.

    Of the transitions of a mode the first that occurs counts, so a later one counts only where
    those before it do not occur. This looks for a contradiction in that: conditions are followed
    back to what they are made of, and what they are made of forward again.

    [if w then (Just x) else Nothing] tested for [Just] says that [w] holds; and what is in it is
    then [x]. *)

type values = (int, Range.t) Hashtbl.t
(** What the signals of a node may be. *)

val narrowed :
  values ->
  read:(values -> Ir.atom -> Range.t) ->
  evaluate:(values -> Ir.equation -> Range.t) ->
  Ir.equation list ->
  (Ir.atom * bool) list ->
  values option
(** What the node's signals may be where these atoms are so at once, if they are among [values];
    [None] if they cannot. The equations are in an order in which each comes after what it reads.
    [values] is left as it is. Errs towards what is possible. *)
