(** The passes over the whole, in order; {!Of_flow} makes what they begin with. *)

type pass = { name : string; pass : Ir.program -> Ir.program; reason : string }

val program : ?after:(pass -> Ir.program -> unit) -> Ir.program -> Ir.program
(** [after] sees the program after each pass. *)
