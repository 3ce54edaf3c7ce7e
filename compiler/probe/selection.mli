(** The probes that a user asks for.

    A name stands for the signals whose way from the root ends in it, [v], [wallFollow.v]; for all
    signals of the instances whose way does, [wallFollow]; and for the parts of a record,
    [follow.pose]. Numbers may be left out. [all] is all of them, [assert] the verdicts on
    assertions. What is only handed down is meant only where it is named itself. *)

val claims : string
(** [assert] *)

val margins : string
(** [margin]: the columns of {!Core.Margin} *)

val is_claim : Catalogue.probe -> bool
(** The verdict on an assertion. *)

val is_margin : Catalogue.probe -> bool

val find :
  Catalogue.probe list -> string list -> (Catalogue.probe list, string * string option) result
(** In the order of the catalogue; or a name that nothing has, and the nearest one that something
    has. *)
