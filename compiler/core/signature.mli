(** The types of the primitives, with units erased. *)

val of_primitive : Primitive.t -> Ir.ty list -> Ir.ty option
(** The primitive's type at these type arguments; [None] if their number is wrong. *)

val event : Ir.ty -> Ir.ty
(** [Event a] *)

val either : Ir.ty -> Ir.ty -> Ir.ty
(** [Either a b] *)

val frame : Ir.ty
(** [Frame] from the library's Vision module *)

val tag_frame : Ir.ty
(** [TagFrame] from the library's Tags module *)

val scan : Ir.ty -> Ir.ty
(** [Scan] from the library's Lidar module, with this size *)

val imu : Ir.ty
(** [Imu] from the library's Imu module *)

(** {1 Types and functions of the library's Display module} *)

val mark : Ir.ty
val text : Ir.ty
val drawing : Ir.ty

val reading : Ir.Global.t
(** The function to which the library's [number] is translated. Its first argument is the unit, as a
    string. *)
