(** Structure of values. *)

val leaves : Ir.shape -> Ir.ty list

val split : Ir.shape list -> 'a list -> 'a list list
(** Splits a list that has one element for each leaf into one list for each shape. *)

val payload : Ir.sum_constructor -> Ir.ty list
(** All leaves of a constructor's fields, in order. *)

val foreign : Ir.sum array -> Ir.ty -> Ir.foreign_type list
(** All foreign types in a type. *)

val of_the_instant : Ir.sum array -> Ir.ty -> Ir.foreign_type option
(** A non-copyable foreign type inside this type, if there is one. Its values are valid only within
    an instant, because C owns their memory. *)

val is_image : Ir.foreign_type -> bool
(** Whether this is the type of camera images, the only foreign type that hosts support
    ([frob/image.h]). *)

val for_hosts : Ir.sum array -> Ir.shape -> bool
(** Whether hosts support all foreign types in the shape. *)

val mentions_foreign : Ir.sum array -> Ir.shape -> bool
(** Whether the shape contains any foreign type, copyable or not. *)
