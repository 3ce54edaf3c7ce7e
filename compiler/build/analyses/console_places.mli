(** Where a program requests the parts of its console. *)

val at_uses : Typing.Ir.definition -> Core.Ir.control list -> Core.Ir.control list
(** If an instance of the library requests a control, as for the bumpers of the robot `ros`, its
    span becomes the place in the program that uses the capability first. *)
