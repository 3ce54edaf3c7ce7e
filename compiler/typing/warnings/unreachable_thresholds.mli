(** Warns about thresholds that the distance readings of a robot never cross.

    Code: [W0310] a distance from [frontSonar], [sideSonar] or [rightSonar] is compared with a
    constant beyond the robot's [sonarReach], so the result is always the same. *)

val warn :
  Fact.t Basis.Facts.t -> Resolve.Ir.program -> robot:Ir.Global.t option -> Ir.program -> unit
(** Checks the definitions of the program's own modules. [robot]: the input type of the robot that
    the program is compiled for, needed if the program's own types do not determine it; [None] if
    unknown. *)
