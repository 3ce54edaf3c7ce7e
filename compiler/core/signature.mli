(** The types of the primitives, after erasure of units. *)

val of_primitive : Primitive.t -> Ir.ty list -> Ir.ty option
(** At these type arguments; [None] if they are not as many as it takes. *)

val event : Ir.ty -> Ir.ty
(** [Event a] *)

val either : Ir.ty -> Ir.ty -> Ir.ty
(** [Either a b] *)

val frame : Ir.ty
(** [Frame], of the library's module Vision *)

val tag_frame : Ir.ty
(** [TagFrame], of the library's module Tags *)

(** {1 Of the library's module Display} *)

val mark : Ir.ty
val text : Ir.ty
val drawing : Ir.ty

val reading : Ir.Global.t
(** The function that [number] becomes, of the unit as a text first. *)
