(** What values are made of. *)

val leaves : Ir.shape -> Ir.ty list

val split : Ir.shape list -> 'a list -> 'a list list
(** What belongs to the leaves of several shapes, given in a row, by shape. *)

val payload : Ir.sum_constructor -> Ir.ty list
(** All leaves of a constructor's fields, in order. *)

val foreign : Ir.sum array -> Ir.ty -> Ir.foreign_type list
(** All foreign types in a type. *)

val of_the_instant : Ir.sum array -> Ir.ty -> Ir.foreign_type option
(** The foreign type that keeps values of a type from outliving the instant, if any: one that is not
    copyable, of which C keeps the memory. *)

val is_image : Ir.foreign_type -> bool
(** What a camera saw: the one foreign type that hosts know ([frob/image.h]). *)

val for_hosts : Ir.sum array -> Ir.shape -> bool
(** Whether hosts know all foreign types in it. *)

val mentions_foreign : Ir.sum array -> Ir.shape -> bool
(** Any foreign type, copyable or not. *)
