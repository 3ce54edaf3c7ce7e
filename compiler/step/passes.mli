(** The passes over whole programs, in order, which follow {!Of_flow}. *)

val program : ?after:(Ir.program Basis.Pass.t -> Ir.program -> unit) -> Ir.program -> Ir.program
(** [after] receives the program after each pass. *)
