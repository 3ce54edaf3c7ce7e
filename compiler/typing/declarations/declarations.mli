(** The declarations of types and units, read into an {!Environment}. *)

val program : Written.t -> Resolve.Ir.program -> Ir.data list
(** Fills the environment; the data types, used before users. A unit that has no scale, as [0 m], is
    [E0324]. *)
