(** The passes over a whole program that follow {!Of_flow}, in order. *)

val program : ?after:(Ir.program Basis.Pass.t -> Ir.program -> unit) -> Ir.program -> Ir.program
(** [after] receives the program after each pass. *)
