(** Enumerations for text fields of ROS 2 messages. Each one has an instance of [RosText], which
    defines a string for each constructor. *)

val is_enumeration : Ros_declarations.t -> Typing.Ir.ty -> bool
(** Whether the type is an enumeration (its constructors have no fields), or a [Maybe] of an
    enumeration. *)

val check : Ros_declarations.t -> at:Basis.Span.t -> in_:string -> Typing.Ir.ty -> unit
(** Checks that such a type has an instance of [RosText], and that its strings are distinct
    literals. *)

val all : Ros_declarations.t -> Cgen.Node_table.texts list
(** All enumerations that have an instance of [RosText]. *)
