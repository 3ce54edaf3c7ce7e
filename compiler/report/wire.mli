(** The resolution of speeds in the robot's protocol. *)

type step = { quantity : string; size : float; unit_ : string }
type t = { robot : string; steps : step list }
