(** Builds Core programs by hand. Types are inferred from the parts. *)

open Core.Ir

val float : ty
val local : int -> string -> ty -> binder
val var : binder -> expr
val number : float -> expr
val tuple : expr list -> expr
val component : expr -> int -> expr
val if_ : expr -> expr -> expr -> expr
val lambda : binder list -> expr -> expr
val apply : expr -> expr list -> expr
val let_ : binder -> expr -> expr -> expr
val binary : Core.Primitive.t -> expr -> expr -> expr
val ( + ) : expr -> expr -> expr
val ( * ) : expr -> expr -> expr

(** {1 Signal functions} *)

val proc : string -> binder -> equation list -> expr -> expr
val ( := ) : binder -> expr -> equation
val run : binder -> expr -> expr -> equation
val delay : expr -> expr
val derivative : expr

(** {1 Definitions in the main module} *)

type scheme = { name : string; parameters : variable list; ty : ty }

val global : scheme -> ty list -> expr
(** An instance of the definition at some types. *)

val define : ?parameters:variable list -> string -> expr -> definition * scheme

(** {1 Data} *)

val a : variable
val b : variable
val c : variable
val maybe : ty -> ty
val nothing : ty -> expr
val just : expr -> expr
val is_just : expr -> expr
val from_just : expr -> expr
val program : definition list -> program
val main : string -> Global.t
