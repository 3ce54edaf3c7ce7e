(** The resolution of speeds in the protocol of the program's robot. *)

type step = { quantity : string; size : float; unit_ : string }
type t = { robot : string; steps : step list }
