(** Enters the declarations of types and units into an {!Environment}. *)

val program : Annotation.t -> Resolve.Ir.program -> Ir.data list
(** Fills the environment and returns the data types in dependency order. Reports a unit whose scale
    is zero or out of range, such as [0 m], as [E0324]. *)
