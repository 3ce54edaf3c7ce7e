(** Definitions that all random programs may use: the text of [shared.frob]. *)

val text : string
