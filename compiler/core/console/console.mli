(** The controls that a program requests from its operator: buttons, knobs and so on, identified by
    labels.

    In the library, the type [Console] has one constructor without fields. The controls that a
    program requests are known only after all static code has run ({!Specialize.Operator}).
    {!declare} then turns them into the fields of that type, and from then on a console is an
    ordinary record. *)

val asks : Ir.program -> bool
(** Might any definition request a control? *)

val asks_itself : Ir.expr -> bool
(** Does the expression itself request a control? Ignores the definitions that it calls. *)

val is_console : Ir.Global.t -> bool
(** Is this the type [Console]? *)

val has_name : module_:string -> string -> bool
(** Is this the name of the type [Console]? *)

val declare : Ir.control list -> Ir.program -> Ir.program
(** Sets the fields of the type [Console] to these controls, in this order. *)

val field : Ir.control list -> string -> int
(** The index of the field with this label. *)

(** The value of a field while the operator does not use the console. *)
type rest = No_event | Off of bool | At of float

val at_rest : Ir.control_kind -> rest

val map_label : string
(** The label to display for the map, since the program does not give it one. *)

val tags_label : string -> string
(** Given a camera's label, returns the label of the control for the tags that the camera sees.
    Hosts use it to find the camera. *)

val lidar_label : string -> int -> string
(** Given a lidar's label and a number of directions, returns the label of the control for the
    lidar's scans, resampled to that number of directions. Hosts use it to find the lidar. *)

val camera : Ir.control -> string option
(** The label of the camera that supplies this control; [None] if the control is neither a camera
    nor tags. *)

val simulated : Ir.control -> string option
(** A description of the control if it is a sensor that only the simulator provides: "the lidar
    `lidar`" *)

val describe : Ir.control_kind -> string
(** A description for messages: "a knob from 0 to 1, initially 0.5" *)
