(** Selects the probes that a user names.

    A name selects the signals whose path ends with it ([v], [wallFollow.v]), all signals of the
    instances whose path ends with it ([wallFollow]), and the parts of a record ([follow.pose]). The
    numbers in a path may be omitted. [all] selects everything, [assert] the verdicts of assertions.
    A copy of the program's input is selected only if the user gives the signal's own name. *)

val claims : string
(** The name [assert]. *)

val margins : string
(** The name [margin], for the columns of {!Core.Margin}. *)

val is_claim : Catalogue.probe -> bool
(** Whether the probe is the verdict of an assertion. *)

val is_margin : Catalogue.probe -> bool

val find :
  Catalogue.probe list -> string list -> (Catalogue.probe list, string * string option) result
(** The selected probes in the order of the catalogue. The error is a name that selects nothing,
    with the most similar name that would select something. *)
