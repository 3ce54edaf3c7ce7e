(** A sweep as a picture, in SVG: a panel for the share of runs that held, and one for the mean of
    each measure.

    Over two parameters that vary it is a heat map; over one, the mean, and from the least to the
    most; else each panel is a histogram of all runs. Of what else varies, the seeds, worlds and
    robots, all runs of a point are put together. *)

val svg : Setup.t -> Rows.t -> string
