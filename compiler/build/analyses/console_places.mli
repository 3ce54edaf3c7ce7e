(** The places in a program that add controls to its console. *)

val at_uses : Typing.Ir.definition -> Core.Ir.control list -> Core.Ir.control list
(** If an instance in the library requests a control, as for the bumpers of the robot `ros`, sets
    the control's span to the first place in the program that uses the capability. *)
