val resets : Ir.program -> bool array
(** The nodes whose reset anything calls, and the root. *)
