(** The version of Frob, which the build takes from [dune-project], so that git is not required. *)

val number : string
(** For example ["0.2.0"]. *)
