(** Checks the invariants of {!Ir}: variables are declared once, before they are read, in a block
    that contains the use; a variable declared without a value is assigned exactly once on every
    path before it is read; types agree; callees precede callers and get the arguments they need;
    every result is written, and the reset writes every field. *)

val program : Ir.program -> unit
(** Raises {!Basis.Diagnostic.Bug}. *)
