(** The operator's console: a record with one field for each control, named by the control's label.
*)

val apply :
  Core.Ir.control list -> Core.Primitive.console -> size:int -> Value.thunk list -> Value.t
(** Applies a primitive of the console to all its arguments; the console is the last one. [size] is
    the number of directions if the control is a lidar. *)

val at_rest : Core.Ir.control list -> Value.t
(** The console in its initial state, in which it stays until the operator uses it. *)

val control_at_rest : Core.Ir.control -> Value.t
(** The initial value of one control. *)
