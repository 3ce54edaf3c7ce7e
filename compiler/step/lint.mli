(** Checks what {!Ir} promises: variables are declared once and before they are read, in a block
    around the use; what is declared without a value is assigned exactly once on every path before
    it is read; types agree; callees come first and get the arguments they need; every result and,
    in reset, every field is written. *)

val program : Ir.program -> unit
(** Raises {!Basis.Diagnostic.Bug}. *)
