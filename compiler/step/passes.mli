(** The passes over the whole, in order; {!Of_flow} makes what they begin with. *)

val program : ?after:(Ir.program Basis.Pass.t -> Ir.program -> unit) -> Ir.program -> Ir.program
(** [after] sees the program after each pass. *)
