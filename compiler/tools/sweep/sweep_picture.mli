(** Draws a sweep as SVG: a panel for the proportion of successful runs, and one for the mean of
    each measure.

    If two parameters vary, each panel is a heat map. If one varies, it shows the mean and the range
    from the minimum to the maximum. Otherwise it is a histogram of all runs. The runs of a point
    are combined, regardless of their seeds, worlds and robots. *)

val svg : Setup.t -> Rows.t -> string
