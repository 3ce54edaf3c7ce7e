(** Thresholds that a robot's sonar, or what stands for it, never passes.

    Code: [W0310] a distance of [frontSonar], [sideSonar] or [rightSonar] is compared with a
    constant beyond the robot's [sonarReach], so that the answer is always the same. *)

val warn :
  Basis.Diagnostic.sink -> Resolve.Ir.program -> robot:Ir.Global.t option -> Ir.program -> unit
(** In the definitions of the program's own modules. [robot]: the type of the input of the robot
    that the program is for, where its own types leave that open; none if nobody knows. *)
