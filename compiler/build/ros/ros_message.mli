(** Compares a record with its ROS 2 message type.

    Reports [E0509] for a field that no message can have, and [E0510] if the record does not match
    the definition of its message type. A definition is known if its package is in the sourced ROS 2
    installation or is a common package ({!Message_definitions}). *)

val check :
  Ros_declarations.t ->
  named:Basis.Span.t ->
  type_:string ->
  Typing.Ir.ty ->
  Typing.Ir.Global.t ->
  unit
(** [type_]: for example [geometry_msgs/msg/Twist]; [named]: the place in the program that names
    this type. *)
