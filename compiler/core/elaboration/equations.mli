(** Collects the equations of one proc: those in the source, and those that elaboration adds for
    instances inside expressions and for the parts of patterns. *)

type t

val create : unit -> t
val pure : t -> Ir.binder -> Ir.expr -> Basis.Span.t -> unit
val run : t -> Ir.binder -> signal_function:Ir.expr -> input:Ir.expr -> Basis.Span.t -> unit

val parts : t -> Typing.Ir.pattern -> root:Ir.expr -> Basis.Span.t -> unit
(** Adds one equation for each variable of the pattern. *)

val all : t -> Ir.equation list
(** All equations, in the order in which they were added. *)
